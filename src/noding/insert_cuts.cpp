#include "noding/insert_cuts.h"

#include <numeric>

namespace oblast::noding {

Strands insert_cuts(const Strands& strands, std::span<const EdgeCut> cuts) {
  Strands result;
  const std::size_t size = strands.points.size() + cuts.size();
  result.points.reserve(size);
  result.flags.reserve(size);
  result.origin.reserve(size);
  result.ends.reserve(strands.ends.size());
  result.change = strands.change;
  result.group = strands.group;
  result.simplicity = strands.simplicity;
  result.parity = strands.parity;

  const bool first_round = strands.origin.empty();
  const auto copy_range = [&](std::uint32_t begin, std::uint32_t end) {
    result.points.insert(result.points.end(), strands.points.begin() + begin, strands.points.begin() + end);
    for (std::uint32_t v = begin; v < end; ++v)
      result.flags.push_back(static_cast<std::uint8_t>(strands.flags[v] & ~(moved_flag | near_flag)));
    if (first_round) {
      result.origin.resize(result.origin.size() + (end - begin));
      std::iota(result.origin.end() - (end - begin), result.origin.end(), begin);
    } else {
      result.origin.insert(result.origin.end(), strands.origin.begin() + begin, strands.origin.begin() + end);
    }
  };

  std::size_t next_cut = 0;
  for (std::size_t s = 0; s < strands.size(); ++s) {
    const std::uint32_t end = strands.ends[s];
    std::uint32_t copied = strands.begin(s);
    while (next_cut < cuts.size() && cuts[next_cut].edge < end) {
      const std::uint32_t edge = cuts[next_cut].edge;
      copy_range(copied, edge + 1);
      copied = edge + 1;
      const auto moved = static_cast<std::uint8_t>((strands.flags[edge] & near_flag) != 0 ? moved_flag : 0);
      result.flags.back() |= moved;
      for (; next_cut < cuts.size() && cuts[next_cut].edge == edge; ++next_cut) {
        result.points.push_back(cuts[next_cut].at);
        result.flags.push_back(node_flag | added_flag | moved);
        result.origin.push_back(result.origin[result.origin.size() - 1]);
      }
    }
    copy_range(copied, end);
    result.ends.push_back(static_cast<std::uint32_t>(result.points.size()));
  }
  return result;
}

}  // namespace oblast::noding
