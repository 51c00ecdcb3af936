#include "overlay/batches.h"

#include <algorithm>
#include <chrono>
#include <optional>

#include "base/call_memory.h"
#include "base/parallel.h"
#include "base/stage_clock.h"
#include "base/stage_shares.h"

namespace oblast::internal {
namespace {

/// Adds the statistics of parts that were processed in parallel. Each stage gets its share of the elapsed time.
void add_parts(const Array<Statistics>& parts, double elapsed, Statistics& statistics) {
  double seconds[stage_count] = {}, total = 0;
  for (const Statistics& part : parts) {
    statistics.intersections += part.intersections;
    statistics.resolved_polygons += part.resolved_polygons;
    statistics.rounds = std::max(statistics.rounds, part.rounds);
    statistics.largest_displacement = std::max(statistics.largest_displacement, part.largest_displacement);
    for (int i = 0; i < stage_count; ++i) {
      seconds[i] += part.seconds[i];
      total += part.seconds[i];
    }
  }
  for (int i = 0; i < stage_count; ++i)
    if (total > 0) statistics.seconds[i] += elapsed * seconds[i] / total;
}

/// Takes batches out of the strands on demand. A batch with most of the vertices is not copied.
class Batches {
 public:
  Batches(noding::Strands strands, const IndependentParts& parts) : strands_(std::move(strands)), parts_(parts) {
    const std::optional<std::size_t> large = find_large();
    if (!large) return;
    ready_.resize(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (i != *large) ready_[i] = batch_of(strands_, parts, i);
    ready_[*large] = only_batch(std::move(strands_), parts, *large);
  }

  noding::Strands take(std::size_t i) { return ready_.empty() ? batch_of(strands_, parts_, i) : std::move(ready_[i]); }

 private:
  std::optional<std::size_t> find_large() const {
    for (std::size_t i = 0, s = 0; i < parts_.size(); ++i) {
      std::size_t vertices = 0;
      for (; s < parts_.ends[i]; ++s) vertices += strands_.ends[parts_.strands[s]] - strands_.begin(parts_.strands[s]);
      if (vertices > strands_.points.size() / 2) return i;
    }
    return {};
  }

  noding::Strands strands_;
  const IndependentParts& parts_;
  Array<noding::Strands> ready_;
};

void run_batches(noding::Strands strands, const IndependentParts& parts, Statistics& statistics,
                 const BatchWork& work) {
  const auto begin = std::chrono::steady_clock::now();
  Array<Statistics> done(parts.size());
  const auto vertices = static_cast<double>(strands.points.size());
  Batches batches(std::move(strands), parts);
  {
    const Share all(Stage::node, parts_share);
    Share* const share_of_all = Share::current();
    const NoShare by_vertices;  // progress is counted by vertices, not by the loop
    for_ranges(parts.size(), 1, [&](std::size_t i, std::size_t past) {
      for (; i < past; ++i) {
        // A thread that waits inside a part must not begin another part there, because waits would nest.
        isolated([&] {
          noding::Strands part = batches.take(i);
          const Share share(share_of_all, static_cast<double>(part.points.size()) / vertices);
          work.run(i, std::move(part), done[i]);
        });
      }
    });
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  add_parts(done, elapsed.count(), statistics);
}

}  // namespace

void in_batches(noding::Strands strands, PartNeeds needs, Control& control, Statistics& statistics,
                const BatchWork& work) {
  if (!worth_dividing(strands)) {
    work.begin(1);
    return work.run(0, std::move(strands), statistics);
  }
  IndependentParts parts;
  {
    const InStage stage(Stage::collect, parting_share, control, statistics);
    parts = independent_parts(strands, needs);
  }
  work.begin(parts.size());
  if (parts.size() != 1) return run_batches(std::move(strands), parts, statistics, work);
  // One batch that has all strands in their order is not copied.
  if (parts.strands.size() < strands.size() || !std::is_sorted(parts.strands.begin(), parts.strands.end()))
    strands = only_batch(std::move(strands), parts, 0);
  work.run(0, std::move(strands), statistics);
}

}  // namespace oblast::internal
