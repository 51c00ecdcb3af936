#include "noding/meetings.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/large_pages.h"
#include "base/parallel.h"
#include "noding/arrange_cuts.h"
#include "noding/clearance.h"
#include "noding/meeting_test.h"
#include "noding/pair_finder.h"
#include "noding/repeated_pieces.h"

namespace oblast::internal::noding {
namespace {

/// Whether two vertices of the strand that are nodes lie at one place.
bool touches_itself(const Strands& strands, std::size_t strand) {
  Array<Point> nodes;
  for (std::uint32_t v = strands.begin(strand); v + 1 < strands.ends[strand]; ++v)
    if (strands.flags[v] & node_flag) nodes.push_back(strands.points[v]);
  std::sort(nodes.begin(), nodes.end(), lexicographically_less);
  return std::adjacent_find(nodes.begin(), nodes.end()) != nodes.end();
}

/// Adds the strands that touch themselves. Where edges of others go through the same vertex, the search need not visit
/// the two edges of the strand together (pair_finder.h); but both its vertices there are nodes.
void add_touching(const Strands& strands, Array<std::uint32_t>& tangled) {
  Array<std::uint8_t> found(strands.size(), 0);
  for_ranges(strands.size(), grain(strands.size(), strands.points.size()), [&](std::size_t first, std::size_t past) {
    for (; first < past; ++first)
      found[first] = strands.simplicity[first] == Simplicity::assumed && touches_itself(strands, first);
  });
  for (std::uint32_t s = 0; s < strands.size(); ++s)
    if (found[s]) tangled.push_back(s);
}

}  // namespace

LargeArray<EdgeCut> find_meetings(Strands& strands, Grouping grouping, Settling settling,
                                  const std::function<void()>& checkpoint, Clearance* clearance, FirstFindings* first) {
  LargeArray<RepeatedPiece> repeated;
  if (grouping == Grouping::by_moved) repeated = flag_repeated_pieces(strands);
  LargeArray<Run> runs = monotone_runs(strands, grouping, clearance ? clearance->run_margins() : RunMargins{});
  const bool repeats = runs.size() > runs_of_one_cell, parallel = runs.size() > runs_of_one_thread;
  Found by_caller;
  ContactCount contact_count;
  std::optional<PerThread<Found>> by_thread;
  if (parallel) by_thread.emplace();
  const auto visit = [&](std::span<const RunPair> pairs) {
    if (checkpoint) checkpoint();
    Found& mine = by_thread ? by_thread->local() : by_caller;
    if (repeats) mine.recent.prepare();
    MeetingTest(strands, settling, mine, contact_count, clearance, first).test(pairs);
  };
  UnsureEdge unsure;
  if (clearance) unsure = [clearance](std::uint32_t edge) { clearance->flag(edge); };
  find_pairs(strands.points, std::move(runs), std::ref(visit), PairGoal::meetings, unsure);
  Array<Found> by_threads;
  if (by_thread)
    for (Found& part : *by_thread) by_threads.push_back(std::move(part));
  const std::span<const Found> found = by_thread ? std::span<const Found>(by_threads) : std::span(&by_caller, 1);
  if (first) {
    Array<std::uint32_t>& tangled = first->tangled;
    for (const Found& part : found) {
      tangled.insert(tangled.end(), part.first.tangled.begin(), part.first.tangled.end());
      first->identical |= part.first.identical;
    }
    if (first->seeks_tangled) add_touching(strands, tangled);
    std::sort(tangled.begin(), tangled.end());
    tangled.erase(std::unique(tangled.begin(), tangled.end()), tangled.end());
    if (first->asks_for_change()) return {};
  }
  Array<std::span<const EdgeContact>> blocks;
  for (const Found& part : found)
    for (const auto& block : part.contacts.blocks()) blocks.emplace_back(block);
  if (blocks.empty()) return {};
  LargeArray<EdgeCut> cuts = arrange_cuts(strands, blocks, settling, clearance);
  copy_cuts(strands, repeated, cuts);
  if (!clearance)
    for (const EdgeCut& cut : cuts) strands.flags[cut.edge] |= near_flag;
  return cuts;
}

}  // namespace oblast::internal::noding
