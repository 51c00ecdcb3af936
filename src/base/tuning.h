// All constants that choose between two ways of doing the same thing (a small call or a large one, a sample or all), or
// that say how much is done at a time (a batch, a leaf, a range, a task). A promise can break on only one side of such
// a constant, and a test of sixty edges would never reach the other side. So all of them are here. Test builds set all
// of them tiny, or draw them at random (tuning_setting.h; `make tiny`).
//
//   choose("name", usual, tiny)
//
// No value may change a byte of a result: tests/golden and oblast_same_bytes run in every setting. The constants that
// do decide bytes are a part of the definition of results. They are at the end, and the same in every setting.
//
// Each comment says what the constant trades and gives the measurement. A commit in brackets has the figures. "Level"
// means that the difference was within the spread of two measurements. Not here: bounds of rounding errors, sizes of
// formats and registers, the domain, how far ahead memory is prefetched (base/fetch.h).
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/tuning_setting.h"

namespace oblast::internal::tuning {

// ---- Calls and their memory ----------------------------------------------------------------------------------------

/// A call on up to this many vertices has its memory on the stack and stays on its thread. It saves the start of the
/// scheduler (as long as the overlay of a few dozen edges), but does not use other cores. 3,000 pairs: 456 to 287
/// million instructions (ec89472).
inline constexpr std::size_t small_call = choose("small_call", 128, 16);

/// Bytes on the stack of a small call. When they are used up, memory comes from the workspace or the system. A call on
/// 128 vertices makes some eighty arrays. Pairs 9.6 to 7.7 us (604ab32).
inline constexpr std::size_t call_memory_bytes = choose("call_memory_bytes", 48 << 10, 2 << 10);

/// Bytes that a workspace keeps for small calls whose own memory is used up. Not measured.
inline constexpr std::size_t small_call_kept_bytes = choose("small_call_kept_bytes", 512 << 10, 8 << 10);

/// Number of block sizes in that memory: 32 bytes, 64 bytes, and so on, doubled. Longer blocks come from the system.
/// Not measured.
inline constexpr std::size_t call_memory_sizes = choose("call_memory_sizes", 10, 4);

/// A workspace keeps blocks of at least this many bytes. The system provides shorter ones at little cost. Dissolve of
/// Normandie 7.7 to 5.4 ms with a workspace (efd3038). Not measured against other values.
inline constexpr std::size_t shortest_kept_block = choose("shortest_kept_block", 64 << 10, 256);

/// A kept block is not used for an array if it is more than this many times as long as the array. Not measured.
inline constexpr std::size_t largest_kept_excess = choose("largest_kept_excess", 2, 2);

/// An array of at least this many bytes requests large pages, and all cores touch it first. Shorter arrays do not fill
/// a large page, and are resized directly: pairs 676 to 636 ms, with other changes (4b82e03).
inline constexpr std::size_t large_array_bytes = choose_power_of_two("large_array_bytes", 2 << 20, 512);

/// Number of pieces of that size that a task touches. Not measured.
inline constexpr std::size_t touched_pieces_a_task = choose("touched_pieces_a_task", 2, 1);

/// Bytes of the pages that are requested and given back: the large pages of the processor. In tests its small pages, so
/// that short arrays do both.
inline constexpr std::size_t large_page = setting == Setting::usual ? 2 << 20 : 4 << 10;

// ---- Calls of the progress function --------------------------------------------------------------------------------

/// Microseconds between two calls of the progress function, which takes the caller's time. Not measured.
inline constexpr std::size_t microseconds_a_question = choose("microseconds_a_question", 5000, 50);

/// Steps of a sequential loop, some tens of nanoseconds each, between two readings of the clock. Not measured.
inline constexpr std::size_t steps_a_poll = choose("steps_a_poll", 1024, 1);

/// The same for a loop over contours, whose steps take longer. Not measured.
inline constexpr std::size_t contours_a_poll = choose("contours_a_poll", 16, 1);

// ---- Loops on all cores: indices per range or task -----------------------------------------------------------------
//
// A small value costs more tasks, at some microseconds each (with cold caches); a large one leaves cores idle. With the
// usual values a task takes between a quarter of a millisecond and a few milliseconds. Finer tasks gained nothing
// (docs/speed.md, "What was tried and left"). Not measured against other values, unless a comment says so.

inline constexpr std::size_t parts_a_task = choose("parts_a_task", 1 << 15, 16);  ///< vertices, in loops over contours
/// One thread sorts up to this many items; more are divided. Not measured against other values.
inline constexpr std::ptrdiff_t sorted_items_of_one_task = choose("sorted_items_of_one_task", 1 << 13, 8);
inline constexpr std::size_t validated_points_a_range = choose("validated_points_a_range", 1 << 16, 16);
inline constexpr std::size_t boxes_a_task = choose("boxes_a_task", 8192, 8);
inline constexpr std::size_t strands_a_task = choose("strands_a_task", 256, 4);
inline constexpr std::size_t hashed_edges_a_task = choose("hashed_edges_a_task", 1 << 15, 16);
inline constexpr std::size_t sampled_edges_a_range = choose("sampled_edges_a_range", 1 << 15, 16);
inline constexpr std::size_t clearance_points_a_range = choose("clearance_points_a_range", 1 << 16, 16);
/// Words of 64 bits; each bit says whether a run begins at an edge.
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
inline constexpr std::size_t bordered_paths_a_task = choose("bordered_paths_a_task", 4096, 4);
inline constexpr std::size_t row_vertices_a_range = choose("row_vertices_a_range", 16384, 16);
inline constexpr std::size_t rings_a_task = choose("rings_a_task", 1024, 2);
inline constexpr std::size_t joined_polygons_a_task = choose("joined_polygons_a_task", 512, 2);
inline constexpr std::size_t centres_a_task = choose("centres_a_task", 4096, 8);
inline constexpr std::size_t cells_a_range = choose("cells_a_range", 4096, 8);
inline constexpr std::size_t checked_pieces_a_range = choose("checked_pieces_a_range", 1024, 4);
inline constexpr std::size_t bounds_a_task = choose("bounds_a_task", 4096, 8);

// ---- Stage 1: collect ----------------------------------------------------------------------------------------------

/// Most edges of a leaf of the tree along rings. Edges of a short leaf have one direction; long leaves make a small
/// tree. Leaves with a fixed number of edges: level (docs/speed.md).
inline constexpr std::uint32_t longest_ring_leaf = choose("longest_ring_leaf", 8, 1);

/// Comparisons per leaf after which the tree gives up, and noding decides. Bounds the cost of long winding rings.
/// Not measured against other values.
inline constexpr std::size_t looks_a_ring_leaf = choose("looks_a_ring_leaf", 64, 2);

/// Vertices of a batch of independent parts; a call on fewer is not divided. The arrays of such a batch fit the
/// second-level cache. Full fires 12.9 to 5.2 s (5408990). Other values: not noted.
inline constexpr std::size_t batch_vertices = choose("batch_vertices", 4000, 8);

/// Comparisons per box after which all boxes below a node of the tree count as connected. Parts may then be larger than
/// necessary. Bounds the cost if long boxes overlap. Not measured against other values.
inline constexpr std::size_t looks_a_connected_box = choose("looks_a_connected_box", 64, 1);

// ---- Stage 2: identical edges --------------------------------------------------------------------------------------

/// Identical edges are not searched for among up to this many vertices: comparing so few edges is faster (727097a,
/// figures not noted).
inline constexpr std::size_t few_merged_vertices = choose("few_merged_vertices", 256, 4);

/// With at least this many edges, a sample decides whether any are repeated. With fewer, the search is as fast
/// (1e19c55).
inline constexpr std::size_t edges_worth_sampling = choose("edges_worth_sampling", 1 << 14, 16);

/// Approximate number of edges in the sample. Trades its cost, one pass over the points, for certainty. Not measured
/// against other values.
inline constexpr std::size_t sampled_edges = choose("sampled_edges", 1 << 11, 8);

/// If at least this fraction of the sample is repeated, every edge goes into one table, without the first pass with
/// bits. Not measured against other values.
inline constexpr double many_repeated = choose("many_repeated", 0.2, 0.05);

/// Bits per edge in the table of hashes that may be repeated. More bits give fewer false hits, but take more of the
/// cache. Not measured against other values.
inline constexpr std::size_t repeated_bits_an_edge = choose("repeated_bits_an_edge", 16, 2);

/// The same for the second table, which has what the first one found.
inline constexpr std::size_t repeated_bits_a_hash = choose("repeated_bits_a_hash", 64, 2);

/// Edges per core in the search: each core reads all edges, for its share of the table. Not measured against other
/// values.
inline constexpr std::size_t repeated_edges_a_core = choose("repeated_edges_a_core", 1 << 16, 16);

// ---- Stage 2: the search for meetings ------------------------------------------------------------------------------

/// Most edges of a run. The boxes of long runs exclude little; short runs are many. This value was the best: concentric
/// rings 5.1 to 3.0 s (dec4a6e). At most 32, the bits of a mask.
inline constexpr std::uint32_t longest_run = choose("longest_run", 16, 2);

/// Up to this many boxes are compared all with all: that is cheaper than the copies of further cuts. Then no pair is
/// visited twice, and everything stays on the caller's thread. Full fires 12.9 to 5.2 s (5408990).
inline constexpr std::size_t runs_of_one_cell = choose("runs_of_one_cell", 512, 4);

/// The same for clipped edges, which lie close together. Windmill 3.25 to 2.6 s, with other changes (1e19c55).
inline constexpr std::size_t clipped_edges_of_one_cell = choose("clipped_edges_of_one_cell", 128, 3);

/// A cell uses boxes as long as a cut multiplies its entries by at most this factor. Beyond it edges are clipped.
/// Bundles of slanting edges 3.3 to 0.04 s (abb1cde). Other values: not noted.
inline constexpr double box_growth = choose("box_growth", 1.2, 1.05);

/// A cut that multiplies the entries by at least this factor is no progress: nearly everything meets everything, and is
/// compared. Smaller in tests, because their small samples misjudge cuts, and small leaves make many cuts. 1.8:
/// 1e19c55, figures with other changes.
inline constexpr double largest_growth = choose("largest_growth", 1.8, 1.4);

/// A clipped cell is cut along an edge if a cut along an axis has a factor above `good`. Edges are tried until one has
/// a factor below `acceptable`; the first few are always tried. Above `worth_parting`, edges that only touch the line
/// are divided, although they must then be examined again. Not measured against other values.
inline constexpr double good_growth = choose("good_growth", 1.15, 1.0);
inline constexpr double acceptable_growth = choose("acceptable_growth", 1.5, 1.0);
inline constexpr double growth_worth_parting = choose("growth_worth_parting", 1.3, 1.0);

/// Entries in the sample by which cuts are judged, and how many of its edges are tried first. A larger sample is more
/// reliable, and costs more in every cell. Not measured against other values.
inline constexpr std::size_t cut_sample = choose("cut_sample", 31, 7);
inline constexpr std::size_t cut_edges_tried = choose("cut_edges_tried", 5, 1);

/// A run of at least this many edges is divided at a cut. Examining the points of a shorter run gains nothing. Not
/// measured.
inline constexpr std::uint32_t shortest_divided_run = choose("shortest_divided_run", 3, 2);

/// Entries that are classified together at a cut, without branches (1e19c55). At most 256.
inline constexpr std::size_t divided_runs_a_block = choose("divided_runs_a_block", 64, 4);

/// Edges that cross a cell from side to side are matched by sorting if at least one entry in this many is such an edge.
/// Nested rings 0.80 to 0.47 s (dec4a6e). Other values: not noted.
inline constexpr std::size_t entries_a_crosser = choose("entries_a_crosser", 8, 64);

/// Pairs that are passed to the visitor at a time. Not measured.
inline constexpr std::size_t pairs_a_batch = choose("pairs_a_batch", 256, 4);

/// Up to `few_boxes` boxes of a cell are compared all with all, without sorting them on the coarse grid.
/// `box_bucket_bits`: bits of a position on that grid. Pairs 788 to 676 ms (b1625e6). Grids of 64 to 256 positions:
/// level (docs/speed.md).
inline constexpr std::size_t few_boxes = choose("few_boxes", 64, 4);
inline constexpr int box_bucket_bits = choose("box_bucket_bits", 6, 2);

/// Pairs of edges that a thread remembers, because neighbouring cells find the same pairs. Not measured against other
/// values.
inline constexpr std::size_t recent_pairs = choose("recent_pairs", 4096, 8);

/// Cuts per block of a thread's list, and the capacity of the first block. Large blocks in large pages: level
/// (docs/speed.md).
inline constexpr std::size_t cuts_a_block = choose("cuts_a_block", 4096, 3);
inline constexpr std::size_t first_cuts = choose("first_cuts", 32, 2);

/// In contours with up to this many vertices, edges of one polygon are compared, too, which makes second rounds short.
/// In longer ones groups exclude these pairs. Full fires 5.0 to 4.2 s (e24efa9). Other values: not noted.
inline constexpr std::size_t small_strand = choose("small_strand", 32, 4);

// ---- Stage 2: cuts -------------------------------------------------------------------------------------------------

/// Up to this many cuts of an edge are sorted by comparison. More are first distributed to parts of the edge by
/// counting. Sorting and arranging cuts of crossing polygons: 219 to 80 ms (c44264b), with other changes.
inline constexpr std::ptrdiff_t few_cuts = choose("few_cuts", 24, 1);

/// Tasks that distribute cuts to ranges. Each has its own counts, so more tasks need more counts. Not measured.
inline constexpr std::size_t cut_tasks = choose("cut_tasks", 16, 3);

/// Up to this many vertices are moved one by one, which is faster than a call that copies. Not noted (b6a7421).
inline constexpr std::uint32_t few_moved_vertices = choose("few_moved_vertices", 16, 1);

// ---- Curves, graph, labels, links ----------------------------------------------------------------------------------

/// Positions along a curve. Up to this many are sorted by comparison: in total, and in one part of the first digit.
/// Then: items per range of the sort by digits, and parts per task. Not measured against other values (64ad479).
inline constexpr std::size_t few_keys = choose("few_keys", 1999, 8);
inline constexpr std::size_t few_keys_of_a_digit = choose("few_keys_of_a_digit", 1000, 2);
inline constexpr std::size_t keys_a_range = choose("keys_a_range", 1 << 16, 32);
inline constexpr std::size_t digits_a_task = choose("digits_a_task", 64, 32);
inline constexpr std::size_t curve_points_a_task = choose("curve_points_a_task", 32768, 16);

/// Vertices that are classified together as nodes or not, without branches. Not measured.
inline constexpr std::uint32_t stop_vertices_a_block = choose("stop_vertices_a_block", 128, 4);

/// Up to this many directions around a node are sorted by counting, more by comparison. Pairs 676 to 636 ms (4b82e03),
/// with other changes.
inline constexpr std::size_t most_counted_directions = choose("most_counted_directions", 8, 2);

/// Nodes of a range, which one task labels. They fit the second-level cache. Ranges of 1,024 to 4,096: level
/// (docs/speed.md).
inline constexpr std::uint32_t labelled_nodes_a_range = choose("labelled_nodes_a_range", 8192, 8);

/// Nodes of a range. Walks inside ranges are followed in parallel; one core follows walks that leave their range.
/// Not measured against other values.
inline constexpr std::size_t linked_nodes_a_range = choose("linked_nodes_a_range", 8192, 8);

/// With at least this many point-in-region queries, a sweep answers them. Not noted (895cb71).
inline constexpr std::size_t fewest_queries = choose("fewest_queries", 8, 1);

/// Comparisons per box after which every box counts as enclosing and as enclosed, which causes unnecessary queries.
/// Labels of disjoint squares 0.32 to 0.10 s (17d616d). Other values: not noted.
inline constexpr std::size_t looks_an_enclosing_box = choose("looks_an_enclosing_box", 16, 1);

// ---- Stage 6: assemble ---------------------------------------------------------------------------------------------

/// Children of a node of the tree with which traces find what is near them. Not measured.
inline constexpr std::size_t box_tree_fan = choose("box_tree_fan", 4, 2);

/// Up to this many vertices of a ring are copied one by one, which is faster (b6a7421, not noted).
inline constexpr std::size_t few_copied_vertices = choose("few_copied_vertices", 8, 1);

// ---- Windows -------------------------------------------------------------------------------------------------------

/// Most sides of a window. With more, searching the sides near an edge costs too much (ac7ea0a, not noted).
inline constexpr std::size_t most_window_sides = choose("most_window_sides", 64, 6);

/// With up to this many sides, all are compared with an edge. With more, the sides near it are searched. Not measured.
inline constexpr std::uint32_t few_window_sides = choose("few_window_sides", 12, 3);

/// Bytes on the stack, enough for small windows. Not measured against other values.
inline constexpr std::size_t window_scratch_bytes = choose("window_scratch_bytes", 12288, 256);

/// Edges of a block, which has one box. Not measured.
inline constexpr std::uint32_t window_edges_a_block = choose("window_edges_a_block", 32, 2);

/// Up to this many pairs of edges are all compared, which is faster than preparing a search. Then: edges of a run, runs
/// of a block, and tests per edge after which the fast path declines. Not measured against other values.
inline constexpr std::size_t few_window_pairs = choose("few_window_pairs", 3000, 4);
inline constexpr std::uint32_t window_edges_a_run = choose("window_edges_a_run", 8, 2);
inline constexpr std::uint32_t window_runs_a_block = choose("window_runs_a_block", 4, 2);
inline constexpr std::size_t window_tests_an_edge = choose("window_tests_an_edge", 32, 2);

/// With up to this many pairs of edges, a classic compares everything that rounding moved with everything. With more,
/// it uses a tree. Not measured.
inline constexpr std::size_t few_moved_pairs = choose("few_moved_pairs", 4096, 16);

// ---- vatti and its layers ------------------------------------------------------------------------------------------

/// Edges of a leaf of the tree of a contour. Not measured (6bbab72).
inline constexpr std::uint32_t contour_edges_a_leaf = choose("contour_edges_a_leaf", 8, 1);

/// Most columns and rows of the raster that finds passive contours. Bounds its memory. Not measured.
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

/// Queries per task. Not measured.
inline constexpr std::size_t queries_a_task = choose("queries_a_task", 4096, 4);

/// Contours per task, of which one thread computes the areas. Not measured.
inline constexpr std::size_t measured_contours_a_task = choose("measured_contours_a_task", 256, 2);

// ---- What decides bytes --------------------------------------------------------------------------------------------
//
// With another value results would differ in the last places of coordinates and in the positions of vertices; with the
// last two, triangulations would differ. So these constants are a part of the definition, and the same in every
// setting.

/// Rounds of noding up to this one make a vertex at every crossing. Later rounds settle a crossing at an end of an edge
/// within `settling_ulps` (noding/meetings.h). Over two million hostile cases: at most 6 rounds, 1.56 ulps.
inline constexpr std::uint64_t last_nearest_round = 1;
inline constexpr double settling_ulps = 2;

/// In the rounds after this one, new vertices are rounded ever more coarsely, which guarantees that noding ends. No
/// case has needed more than seven rounds.
inline constexpr std::uint64_t last_patient_round = 24;

/// For points on one circle, the triangulation depends on the order of insertion. This order depends on the number of
/// rounds of insertion (more are useless below 8^16 points), and along the curve in each round on how many points in
/// one of its cells are sorted again inside the cell (an even number). Neither was measured against other values.
inline constexpr int insertion_rounds = 16;
inline constexpr std::uint32_t curve_crowd = 16;

}  // namespace oblast::internal::tuning
