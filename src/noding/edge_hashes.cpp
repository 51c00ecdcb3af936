#include "noding/edge_hashes.h"

#include "base/parallel.h"
#include "base/tuning.h"
#include "plane/point_hash.h"

namespace oblast::internal::noding {

LargeArray<std::uint32_t> hash_edges(const LargeArray<Point>& points) {
  LargeArray<std::uint32_t> hashes;
  if (points.empty()) return hashes;
  resize_uninitialized(hashes, points.size() - 1);
  constexpr std::size_t edges_a_task = tuning::hashed_edges_a_task;
  for_ranges(hashes.size(), edges_a_task, [&](std::size_t begin, std::size_t end) {
    std::uint64_t from = hash(points[begin]);
    for (std::size_t e = begin; e < end; ++e) {
      const std::uint64_t to = hash(points[e + 1]);
      hashes[e] = edge_hash(from, to);
      from = to;
    }
  });
  return hashes;
}

/// Each core looks after its share of the table.
Array<std::uint32_t> repeated_hashes(const Strands& strands, const LargeArray<std::uint32_t>& hashes) {
  constexpr std::size_t bits_an_edge = tuning::repeated_bits_an_edge, edges_a_core = tuning::repeated_edges_a_core;
  const std::size_t shares =
      std::clamp<std::size_t>(hashes.size() / edges_a_core, 1, std::min<std::size_t>(core_count(), 8));
  HashBits seen(hashes.size(), bits_an_edge);
  Array<Array<std::uint32_t>> repeated(shares);
  for_ranges(shares, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t share = begin; share < end; ++share) {
      const auto is_mine = [&](std::uint32_t e) { return shares == 1 || seen.share_of(hashes[e], shares) == share; };
      for_edges(
          strands,
          [&](std::uint32_t e) {
            if (is_mine(e)) seen.prefetch(hashes[e]);
          },
          [&](std::uint32_t e, std::size_t) {
            if (is_mine(e) && seen.add(hashes[e])) repeated[share].push_back(hashes[e]);
          });
    }
  });
  for (std::size_t share = 1; share < shares; ++share)
    repeated[0].insert(repeated[0].end(), repeated[share].begin(), repeated[share].end());
  return std::move(repeated[0]);
}

double repeated_part(const Strands& strands) {
  constexpr std::size_t enough = tuning::sampled_edges, edges_a_range = tuning::sampled_edges_a_range;
  const LargeArray<Point>& points = strands.points;
  const std::size_t edges = points.size() - 1;
  const std::uint64_t one_in = edges / enough + 1;
  const auto is_chosen = [&](std::size_t e) {
    const std::uint64_t sum = std::bit_cast<std::uint64_t>(points[e].x) + std::bit_cast<std::uint64_t>(points[e + 1].x);
    return sum * 0x9e3779b97f4a7c15ULL <= ~std::uint64_t{0} / one_in;
  };
  Array<Array<std::uint64_t>> found(range_count(edges, edges_a_range));
  for_numbered_ranges(edges, edges_a_range, [&](std::size_t range, std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e)
      if (is_chosen(e)) found[range].push_back(hash(points[e]) + hash(points[e + 1]));
  });
  Array<std::uint64_t> chosen;
  for (const auto& hashes : found) chosen.insert(chosen.end(), hashes.begin(), hashes.end());
  // Copies are chosen together or not at all. A sample that is much smaller than expected may therefore miss all the
  // copies of a few edges, and says nothing.
  if (chosen.size() * 2 < edges / one_in) return tuning::many_repeated / 2;
  std::sort(chosen.begin(), chosen.end());
  const auto different = std::unique(chosen.begin(), chosen.end()) - chosen.begin();
  return 1 - static_cast<double>(different) / static_cast<double>(chosen.size());
}

}  // namespace oblast::internal::noding
