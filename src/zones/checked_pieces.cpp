#include "zones/checked_pieces.h"

#include <algorithm>

#include "base/parallel.h"

namespace oblast::internal::zoning {

Array<std::uint32_t> CheckedPieces::check(const Array<std::uint32_t>& some, const Diagram& diagram,
                                          const PieceEnds& ends, const Room& room) {
  Array<Array<std::uint32_t>> triangles(range_count(some.size(), tuning::checked_pieces_a_range));
  Array<std::uint32_t> parts(some.size());
  for_numbered_ranges(some.size(), tuning::checked_pieces_a_range,
                      [&](std::size_t range, std::size_t k, std::size_t end) {
                        PieceCheck check(diagram, ends, room);
                        Array<std::uint32_t>& list = triangles[range];
                        for (; k < end; ++k) {
                          parts[k] = check.parts(ends.of_piece[some[k]]);
                          Checked& checked = checked_[some[k]];
                          checked = {check.error(), list.size(), 0, check.is_narrow(), parts[k] == 1};
                          if (parts[k] > 1) continue;
                          checked.count = static_cast<std::uint32_t>(check.triangles().size());
                          list.insert(list.end(), check.triangles().begin(), check.triangles().end());
                        }
                      });
  keep(some, triangles);
  return parts;
}

/// Puts the lists of all ranges behind each other.
void CheckedPieces::keep(const Array<std::uint32_t>& some, Array<Array<std::uint32_t>>& triangles) {
  std::size_t count = triangles_.size();
  Array<std::size_t> begins;
  for (const auto& range : triangles) {
    begins.push_back(count);
    count += range.size();
  }
  grow_uninitialized(triangles_, count);
  for_numbered_ranges(some.size(), tuning::checked_pieces_a_range,
                      [&](std::size_t range, std::size_t k, std::size_t end) {
                        std::copy(triangles[range].begin(), triangles[range].end(), triangles_.data() + begins[range]);
                        triangles[range] = {};
                        for (; k < end; ++k) checked_[some[k]].begin += begins[range];
                      });
}

Array<std::uint32_t> CheckedPieces::unsettled(const GrowingDiagram& diagram) const {
  Array<Array<std::uint32_t>> found(range_count(checked_.size(), tuning::checked_pieces_a_range));
  for_numbered_ranges(checked_.size(), tuning::checked_pieces_a_range,
                      [&](std::size_t range, std::size_t i, std::size_t end) {
                        for (; i < end; ++i)
                          if (is_unsettled(checked_[i], diagram)) found[range].push_back(static_cast<std::uint32_t>(i));
                      });
  Array<std::uint32_t> all;
  for (const auto& range : found) all.insert(all.end(), range.begin(), range.end());
  return all;
}

bool CheckedPieces::is_unsettled(const Checked& checked, const GrowingDiagram& diagram) const {
  if (checked.count == 0) return !checked.is_settled;
  const std::uint32_t* const t = triangles_.data() + checked.begin;
  return std::any_of(t, t + checked.count, [&](std::uint32_t triangle) { return diagram.is_near_change(triangle); });
}

}  // namespace oblast::internal::zoning
