// Every constant that chooses between two ways of doing the same thing, or says how much is done at a time: a small
// call or a large one, a sample or all, how many are a batch, a leaf, a range, a task. A promise can break on one side
// of such a constant only, and a test of sixty edges would never see the other side. So all of them stand here, and
// test builds set all of them tiny, or draw them at random (tuning_setting.h; `make tiny`).
//
//   choose("name", usual, tiny)
//
// No value may change a byte of a result: tests/golden and oblast_same_bytes are run in every setting. Those that do
// decide bytes are a part of the definition of results; they are at the end, and the same in every setting.
//
// Each comment says what the constant trades and where that was measured: commits name the figures, "level" is within
// the spread of two measurements, and "not measured" is meant so. Not here: bounds of rounding errors, sizes of formats
// and registers, the domain, how far ahead memory is fetched (base/fetch.h: advice).
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/tuning_setting.h"

namespace oblast::internal::tuning {

// ---- Calls and their memory ----------------------------------------------------------------------------------------

/// Vertices up to which a call brings its memory with it and stays on its thread. Trades the start of the scheduler, as
/// much as overlaying a few dozen edges, for the other cores. 3,000 pairs: 456 to 287 million instructions (ec89472).
inline constexpr std::size_t small_call = choose("small_call", 128, 16);

/// Bytes that a small call has on its stack; then it asks the system. A call on 128 vertices makes some eighty arrays.
/// Pairs 9.6 to 7.7 us (604ab32).
inline constexpr std::size_t call_memory_bytes = choose("call_memory_bytes", 48 << 10, 2 << 10);

/// Sizes of blocks there: 32 bytes and so many doublings less one. Longer ones are the system's. Not measured.
inline constexpr std::size_t call_memory_sizes = choose("call_memory_sizes", 10, 4);

/// Bytes from which on a block is kept by a workspace: shorter ones are found by the system at little cost. Dissolve of
/// Normandie 7.7 to 5.4 ms with a workspace (efd3038); this value against others not measured.
inline constexpr std::size_t shortest_kept_block = choose("shortest_kept_block", 64 << 10, 256);

/// A kept block more than so many times as long as the array is left for a longer one. Not measured.
inline constexpr std::size_t largest_kept_excess = choose("largest_kept_excess", 2, 2);

/// Bytes from which on an array asks for large pages and is first touched by all cores. Half a large page would not be
/// one. Shorter arrays resized as they are: pairs 676 to 636 ms, with other changes (4b82e03).
inline constexpr std::size_t large_array_bytes = choose_power_of_two("large_array_bytes", 2 << 20, 512);

/// Pieces of that size that a task touches. Not measured.
inline constexpr std::size_t touched_pieces_a_task = choose("touched_pieces_a_task", 2, 1);

/// Bytes of the pages that are asked for and given back: those of the processor. In tests its small ones, so that
/// short arrays do both.
inline constexpr std::size_t large_page = setting == Setting::usual ? 2 << 20 : 4 << 10;

// ---- Questions to the caller ---------------------------------------------------------------------------------------

/// Microseconds between two questions whether to go on: a question costs what the caller's function does. Not measured.
inline constexpr std::size_t microseconds_a_question = choose("microseconds_a_question", 5000, 50);

/// Steps of a sequential loop, some tens of nanoseconds each, between two looks at the clock. Not measured.
inline constexpr std::size_t steps_a_poll = choose("steps_a_poll", 1024, 1);

/// The same where a step is a contour looked for in a raster. Not measured.
inline constexpr std::size_t contours_a_poll = choose("contours_a_poll", 16, 1);

// ---- Loops on all cores: indices a range or task -------------------------------------------------------------------
//
// Each trades the cost of a task, some microseconds with what it finds cold, for cores that wait. Usual values are
// between a quarter of a millisecond and a few; finer tasks gained nothing (docs/speed.md, "What was tried and left").
// Except where it is said none was measured against others.

inline constexpr std::size_t parts_a_task = choose("parts_a_task", 1 << 15, 16);  ///< vertices, where by contour
/// Items that are sorted by one thread; more are parted. Not measured against other values.
inline constexpr std::ptrdiff_t sorted_items_of_one_task = choose("sorted_items_of_one_task", 1 << 13, 8);
inline constexpr std::size_t validated_points_a_range = choose("validated_points_a_range", 1 << 16, 16);
inline constexpr std::size_t boxes_a_task = choose("boxes_a_task", 8192, 8);
inline constexpr std::size_t strands_a_task = choose("strands_a_task", 256, 4);
inline constexpr std::size_t hashed_edges_a_task = choose("hashed_edges_a_task", 1 << 15, 16);
inline constexpr std::size_t sampled_edges_a_range = choose("sampled_edges_a_range", 1 << 15, 16);
inline constexpr std::size_t clearance_points_a_range = choose("clearance_points_a_range", 1 << 16, 16);
/// Words of 64 edges of which it is a bit whether a run begins.
inline constexpr std::size_t run_words_a_range = choose("run_words_a_range", 128, 1);
inline constexpr std::size_t crossers_a_task = choose("crossers_a_task", 64, 2);
inline constexpr std::size_t stop_vertices_a_range = choose("stop_vertices_a_range", 1 << 16, 16);
inline constexpr std::size_t stops_a_task = choose("stops_a_task", 32768, 8);
inline constexpr std::size_t listed_nodes_a_range = choose("listed_nodes_a_range", 8192, 8);
inline constexpr std::size_t packed_nodes_a_range = choose("packed_nodes_a_range", 1 << 14, 8);
inline constexpr std::size_t labelled_elements_a_task = choose("labelled_elements_a_task", 1 << 16, 16);
inline constexpr std::size_t selected_chains_a_task = choose("selected_chains_a_task", 32768, 16);
inline constexpr std::size_t linked_nodes_a_task = choose("linked_nodes_a_task", 8192, 8);
inline constexpr std::size_t classified_elements_a_task = choose("classified_elements_a_task", 16384, 16);
inline constexpr std::size_t ring_chains_a_task = choose("ring_chains_a_task", 16384, 8);
inline constexpr std::size_t smallest_vertices_a_range = choose("smallest_vertices_a_range", 1 << 16, 8);
inline constexpr std::size_t rings_a_task = choose("rings_a_task", 1024, 2);
inline constexpr std::size_t joined_polygons_a_task = choose("joined_polygons_a_task", 512, 2);
inline constexpr std::size_t bounds_a_task = choose("bounds_a_task", 4096, 8);

// ---- Stage 1: collect ----------------------------------------------------------------------------------------------

/// Edges of a leaf of the tree along rings. Short leaves know their direction, long ones make a small tree. Leaves of a
/// fixed number of edges: level (docs/speed.md).
inline constexpr std::uint32_t longest_ring_leaf = choose("longest_ring_leaf", 8, 1);

/// Looks a leaf after which the tree gives up and noding tells: bounds what long rings that wander about cost.
/// Not measured against other values.
inline constexpr std::size_t looks_a_ring_leaf = choose("looks_a_ring_leaf", 64, 2);

/// Vertices of a batch of independent parts; a call of fewer is not divided. A batch of this many has its arrays in the
/// second-level cache. Full fires 12.9 to 5.2 s (5408990); other values not noted.
inline constexpr std::size_t batch_vertices = choose("batch_vertices", 4000, 8);

/// Looks a box after which all boxes below a node of the tree are taken to be connected: parts may be larger than they
/// need to be. Bounds the cost where long boxes overlap. Not measured against other values.
inline constexpr std::size_t looks_a_connected_box = choose("looks_a_connected_box", 64, 1);

// ---- Stage 2: identical edges --------------------------------------------------------------------------------------

/// Vertices up to which identical edges are not looked for: so few are compared sooner (727097a, figures not noted).
inline constexpr std::size_t few_merged_vertices = choose("few_merged_vertices", 256, 4);

/// Edges from which on a sample says whether any are repeated: below, to look is as quick (1e19c55).
inline constexpr std::size_t edges_worth_sampling = choose("edges_worth_sampling", 1 << 14, 16);

/// Edges of the sample, about. Trades its cost, one pass over the points, for being sure. Not measured against others.
inline constexpr std::size_t sampled_edges = choose("sampled_edges", 1 << 11, 8);

/// The part of the sample that is repeated, from which on every edge goes into one table, without a first look at bits.
/// Not measured against other values.
inline constexpr double many_repeated = choose("many_repeated", 0.2, 0.05);

/// Bits an edge of the table that tells which hashes may be repeated: more are fewer false ones and more of the cache.
/// Not measured against other values.
inline constexpr std::size_t repeated_bits_an_edge = choose("repeated_bits_an_edge", 16, 2);

/// The same of the second table, of what the first one found.
inline constexpr std::size_t repeated_bits_a_hash = choose("repeated_bits_a_hash", 64, 2);

/// Edges for a core to look for: each core goes over all edges, for its share of the table.
/// Not measured against others.
inline constexpr std::size_t repeated_edges_a_core = choose("repeated_edges_a_core", 1 << 16, 16);

// ---- Stage 2: the search for meetings ------------------------------------------------------------------------------

/// Edges of a run at most: long ones have boxes that say little, short ones are many. Measured best: concentric rings
/// 5.1 to 3.0 s (dec4a6e). At most 32, bits of a mask.
inline constexpr std::uint32_t longest_run = choose("longest_run", 16, 2);

/// Boxes that are compared all with all, for less than to cut them further would copy; no pair is visited twice then,
/// and all of it stays on the caller's thread. Full fires 12.9 to 5.2 s (5408990).
inline constexpr std::size_t runs_of_one_cell = choose("runs_of_one_cell", 512, 4);

/// The same of clipped edges, which lie close. Windmill 3.25 to 2.6 s, with other changes (1e19c55).
inline constexpr std::size_t clipped_edges_of_one_cell = choose("clipped_edges_of_one_cell", 128, 3);

/// Copies that a cut makes, in times what was there, up to which a cell is content with boxes. Bundles of slanting
/// edges 3.3 to 0.04 s, since beyond it edges are clipped (abb1cde); this value against others not noted.
inline constexpr double box_growth = choose("box_growth", 1.2, 1.05);

/// Copies from which on a cut is no progress: everything meets nearly everything, and is compared. In tests less, since
/// the small samples there misjudge cuts, and leaves that are small make many of them. 1.8: 1e19c55, figures with
/// others.
inline constexpr double largest_growth = choose("largest_growth", 1.8, 1.4);

/// Clipped cells are cut along edges where a cut along an axis copies more than `good`; edges are tried until one
/// copies less than `acceptable`, the first few in any case; above `worth_parting` edges that only touch the line are
/// parted, at the price of looking at them again. Not measured against other values.
inline constexpr double good_growth = choose("good_growth", 1.15, 1.0);
inline constexpr double acceptable_growth = choose("acceptable_growth", 1.5, 1.0);
inline constexpr double growth_worth_parting = choose("growth_worth_parting", 1.3, 1.0);

/// Entries that cuts are judged by, and how many edges of them are tried first. A larger sample is surer and costs more
/// in every cell. Not measured against other values.
inline constexpr std::size_t cut_sample = choose("cut_sample", 31, 7);
inline constexpr std::size_t cut_edges_tried = choose("cut_edges_tried", 5, 1);

/// Edges of a run from which on it is divided at a cut; to look at the points of a shorter one gains nothing.
inline constexpr std::uint32_t shortest_divided_run = choose("shortest_divided_run", 3, 2);

/// Entries that are sorted out at a cut together, without branches (1e19c55). At most 256.
inline constexpr std::size_t divided_runs_a_block = choose("divided_runs_a_block", 64, 4);

/// Edges that go through a cell from side to side are matched by a sort where they are at least one in so many.
/// Nested rings 0.80 to 0.47 s (dec4a6e); this value against others not noted.
inline constexpr std::size_t entries_a_crosser = choose("entries_a_crosser", 8, 64);

/// Pairs that go to the visitor at a time. Not measured.
inline constexpr std::size_t pairs_a_batch = choose("pairs_a_batch", 256, 4);

/// Boxes of a cell up to which all are compared with all, without an order on the coarse grid, and bits of the places
/// in that order. Pairs 788 to 676 ms (b1625e6); grids of 64 to 256 places level (docs/speed.md).
inline constexpr std::size_t few_boxes = choose("few_boxes", 64, 4);
inline constexpr int box_bucket_bits = choose("box_bucket_bits", 6, 2);

/// Pairs of edges that a thread remembers, since neighbouring cells bring up the same ones. Not measured against
/// others.
inline constexpr std::size_t recent_pairs = choose("recent_pairs", 4096, 8);

/// Cuts a block of a thread's list, and room for how many is made at first. Large blocks in large pages: level
/// (docs/speed.md).
inline constexpr std::size_t cuts_a_block = choose("cuts_a_block", 4096, 3);
inline constexpr std::size_t first_cuts = choose("first_cuts", 32, 2);

/// Vertices a contour up to which edges of one polygon are compared too, which makes second rounds short; above, groups
/// spare them. Full fires 5.0 to 4.2 s (e24efa9); this value against others not noted.
inline constexpr std::size_t small_strand = choose("small_strand", 32, 4);

// ---- Stage 2: cuts -------------------------------------------------------------------------------------------------

/// Cuts of an edge up to which they are sorted by comparing; more go to parts of the edge by counting first. Sorting
/// and arranging cuts of crossing polygons: 219 to 80 ms (c44264b), with other changes.
inline constexpr std::ptrdiff_t few_cuts = choose("few_cuts", 24, 1);

/// Tasks that put cuts to their ranges; each counts for itself, so more of them are more counts. Not measured.
inline constexpr std::size_t cut_tasks = choose("cut_tasks", 16, 3);

/// Vertices up to which it is quicker to move one by one than to call for a copy. Not noted (b6a7421).
inline constexpr std::uint32_t few_moved_vertices = choose("few_moved_vertices", 16, 1);

// ---- Curves, graph, labels, links ----------------------------------------------------------------------------------

/// Items up to which places along a curve are sorted by comparing, in all and in one part of the first digit; and items
/// a range of the sort by digits, and parts a task. Not measured against other values (64ad479).
inline constexpr std::size_t few_keys = choose("few_keys", 1999, 8);
inline constexpr std::size_t few_keys_of_a_digit = choose("few_keys_of_a_digit", 1000, 2);
inline constexpr std::size_t keys_a_range = choose("keys_a_range", 1 << 16, 32);
inline constexpr std::size_t digits_a_task = choose("digits_a_task", 64, 32);
inline constexpr std::size_t curve_points_a_task = choose("curve_points_a_task", 32768, 16);

/// Vertices that are sorted out by whether they are nodes together, without branches. Not measured.
inline constexpr std::uint32_t stop_vertices_a_block = choose("stop_vertices_a_block", 128, 4);

/// Directions around a node that are put in order by counting; more are sorted by comparing. Pairs 676 to 636 ms
/// (4b82e03), with other changes.
inline constexpr std::size_t most_counted_directions = choose("most_counted_directions", 8, 2);

/// Nodes that are labelled in one go, in the second-level cache, beside other ranges. Ranges of 1,024 to 4,096: level
/// (docs/speed.md).
inline constexpr std::uint32_t labelled_nodes_a_range = choose("labelled_nodes_a_range", 8192, 8);

/// Nodes among which walks are followed side by side. Walks that leave their range are followed by one core.
/// Not measured against other values.
inline constexpr std::size_t linked_nodes_a_range = choose("linked_nodes_a_range", 8192, 8);

/// Point-in-region queries that are worth a sweep of their own. Not noted (895cb71).
inline constexpr std::size_t fewest_queries = choose("fewest_queries", 8, 1);

/// Looks a box after which every box is taken to enclose and to be enclosed: queries that need not be.
/// Labels of disjoint squares 0.32 to 0.10 s (17d616d); this value against others not noted.
inline constexpr std::size_t looks_an_enclosing_box = choose("looks_an_enclosing_box", 16, 1);

// ---- Stage 6: assemble ---------------------------------------------------------------------------------------------

/// Children of a node of the tree that knows what is near a trace. Not measured.
inline constexpr std::size_t box_tree_fan = choose("box_tree_fan", 4, 2);

/// Vertices of a ring up to which it is quicker to copy one by one (b6a7421, not noted).
inline constexpr std::size_t few_copied_vertices = choose("few_copied_vertices", 8, 1);

// ---- Windows -------------------------------------------------------------------------------------------------------

/// Sides of a window at most: more are not worth the search for those that an edge comes near (ac7ea0a, not noted).
inline constexpr std::size_t most_window_sides = choose("most_window_sides", 64, 6);

/// Sides up to which all are compared with an edge; else those near it are searched for. Not measured.
inline constexpr std::uint32_t few_window_sides = choose("few_window_sides", 12, 3);

/// Bytes on the stack that small windows need no more than. Not measured against other values.
inline constexpr std::size_t window_scratch_bytes = choose("window_scratch_bytes", 12288, 256);

/// Edges of a block with one box. Not measured.
inline constexpr std::uint32_t window_edges_a_block = choose("window_edges_a_block", 32, 2);

/// Pairs of edges up to which to look at each is quicker than to set up a search; then edges of a run, runs of a block,
/// and tests an edge after which the window is declined. Not measured against other values.
inline constexpr std::size_t few_window_pairs = choose("few_window_pairs", 3000, 4);
inline constexpr std::uint32_t window_edges_a_run = choose("window_edges_a_run", 8, 2);
inline constexpr std::uint32_t window_runs_a_block = choose("window_runs_a_block", 4, 2);
inline constexpr std::size_t window_tests_an_edge = choose("window_tests_an_edge", 32, 2);

/// Pairs of edges up to which a classic compares all that rounding moved with all; else by a tree. Not measured.
inline constexpr std::size_t few_moved_pairs = choose("few_moved_pairs", 4096, 16);

// ---- vatti and its layers ------------------------------------------------------------------------------------------

/// Edges of a leaf of a contour's tree. Not measured (6bbab72).
inline constexpr std::uint32_t contour_edges_a_leaf = choose("contour_edges_a_leaf", 8, 1);

/// Columns and rows of the raster that tells what is passive, at most: bounds its memory. Not measured.
inline constexpr std::uint32_t largest_raster_side = choose("largest_raster_side", 8192, 4);

// ---- Locating points -----------------------------------------------------------------------------------------------

/// Cells of a locator's grid for an edge, and of one of its cells that is divided: more are shorter lists, and more
/// memory. With 4 bytes a cell, a million points, half of them near 200,000 edges of a snowflake: 145 ms with 2, 103
/// with 4, 96 with 8. With 8 bytes and cells that are divided not measured against other values.
inline constexpr std::size_t located_cells_an_edge = choose("located_cells_an_edge", 2, 1);
inline constexpr std::size_t divided_cells_an_edge = choose("divided_cells_an_edge", 2, 1);

/// Entries of edges in cells for an edge, at most: of the whole grid, and of all divided cells together. Bounds memory
/// where edges are long. Not measured against other values.
inline constexpr std::size_t located_entries_an_edge = choose("located_entries_an_edge", 8, 3);

/// Cells and entries that there may be besides, so that few edges have short lists, too; they fit the first cache. A
/// million points in a square 26 to 8 ms, with 4 bytes a cell.
inline constexpr std::size_t located_cells_besides = choose("located_cells_besides", 4096, 4);

/// Edges of a cell up to which it is not divided: more are longer lists, and fewer grids to build and to go through.
/// Fires, half of the points near vertices, with 8 and with 16: prepared in 163 and 107 ms; 198 and 173 ns a point in
/// single calls, 55 and 73 in one. Circle of 100,000 vertices: 108 and 69 ns, 32 and 25.
inline constexpr std::size_t undivided_edges = choose("undivided_edges", 16, 1);

/// How often a cell is divided, and its cells again, at most. Not measured against other values.
inline constexpr int located_divisions = choose("located_divisions", 4, 2);

/// Edges of a cell up to which all of them are looked at, where it cannot be divided; of more, those of its line are
/// searched in the tree of slabs. Below 256. Not measured against other values.
inline constexpr std::size_t looked_at_in_a_cell = choose("looked_at_in_a_cell", 32, 2);

/// Cells that a task finishes when a grid is built. Not measured.
inline constexpr std::size_t finished_cells_a_task = choose("finished_cells_a_task", 1 << 14, 4);

/// Queries whose cells and edges are fetched before any is answered. Single calls against blocks of this size: fires 57
/// and 25 ns a point all over, 189 and 50 near vertices; against other sizes not measured.
inline constexpr std::size_t queries_a_block = choose("queries_a_block", 64, 3);

/// Queries of a task. Not measured.
inline constexpr std::size_t queries_a_task = choose("queries_a_task", 4096, 4);

/// Contours and points whose measures are added by one thread. Not measured.
inline constexpr std::size_t measured_contours_a_task = choose("measured_contours_a_task", 256, 2);

// ---- What decides bytes --------------------------------------------------------------------------------------------
//
// Another value would be another result, in the last places of coordinates and in where vertices are; or, for the last
// two, another triangulation. So these are part
// of the definition, and the same in every setting.

/// Rounds of noding up to this one put a vertex at every crossing; later ones settle it at an end of an edge within
/// so many ulps (noding/meetings.h). Over two million hostile cases: at most 6 rounds, 1.56 ulps.
inline constexpr std::uint64_t last_nearest_round = 1;
inline constexpr double settling_ulps = 2;

/// From the round after this one on new vertices are rounded ever more coarsely, so that noding ends for certain. No
/// case has needed more than seven rounds.
inline constexpr std::uint64_t last_patient_round = 24;

/// Of points on one circle `triangulate` gives the triangulation that comes of the order in which they are inserted.
/// That is decided by the rounds of insertion (more are of no use below 8^16 points), and along the curve in each round
/// by how many points in one of its cells are sorted again inside it, an even number. Neither measured against other
/// values.
inline constexpr int insertion_rounds = 16;
inline constexpr std::uint32_t curve_crowd = 16;

}  // namespace oblast::internal::tuning
