#include "classics/operand.h"

#include <algorithm>

#include "base/call_memory.h"
#include "exact/orientation.h"

namespace oblast::internal::classics {
namespace {

constexpr std::size_t npos = Place::npos;

std::size_t polygon_of(const RegionView& regions, std::size_t contour) {
  if (contour == npos || regions.polygon_ends.empty()) return contour;
  const auto& ends = regions.polygon_ends;
  return static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), regions.first_contour + contour) -
                                  ends.begin());
}

int turn_at(const Ring& ring, std::size_t i) {
  return exact::orientation(ring.previous(i), ring.points[i], ring.next(i));
}

/// The first vertex at which the ring is not convex; npos if it is convex. Sets `turn` to its direction, which is the
/// turn at the smallest vertex, a corner of the hull. A ring that turns in one direction only, and has one smallest and
/// one largest vertex, is convex and simple.
std::size_t first_not_convex(const Ring& ring, int& turn, const char*& why) {
  const auto smallest = std::min_element(ring.points.begin(), ring.points.end(), lexicographically_less);
  turn = turn_at(ring, static_cast<std::size_t>(smallest - ring.points.begin()));
  const auto is_extreme = [&](std::size_t i) {
    return lexicographically_less(ring.previous(i), ring.points[i]) !=
           lexicographically_less(ring.points[i], ring.next(i));
  };
  int extremes = 0;
  std::size_t third_extreme = npos;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const int t = turn_at(ring, i);
    const bool extreme = is_extreme(i);
    why = "the contour folds back onto itself there";
    if (extreme && t == 0) return i;
    why = "the contour turns the other way there, so it is not convex";
    if (t == -turn && t != 0) return i;
    if (extreme && ++extremes == 3) third_extreme = i;
  }
  why = "the contour goes round more than once, so it is not convex";
  return third_extreme;
}

}  // namespace

Ring clean_ring(std::span<const Point> contour) {
  Ring ring;
  ring.points.reserve(contour.size());
  ring.source.reserve(contour.size());
  for (std::uint32_t i = 0; i < contour.size(); ++i) {
    const Point p{contour[i].x + 0.0, contour[i].y + 0.0};
    if (!ring.points.empty() && ring.points.back() == p) continue;
    ring.points.push_back(p);
    ring.source.push_back(i);
  }
  while (ring.size() > 1 && ring.points.back() == ring.points.front()) {
    ring.points.pop_back();
    ring.source.pop_back();
  }
  return ring;
}

void reverse(Ring& ring) {
  std::reverse(ring.points.begin(), ring.points.end());
  std::reverse(ring.source.begin(), ring.source.end());
}

void Operand::refuse(const std::string& why, std::size_t contour, std::size_t vertex) const {
  std::string what = std::string(method) + ": " + (index == 0 ? "A" : "B");
  if (contour != npos) what += ", contour " + std::to_string(contour);
  if (vertex != npos) what += ", vertex " + std::to_string(vertex);
  what += ": " + why + "; use " + instead + " instead";
  throw Error(ErrorCode::precondition, what, {index, polygon_of(regions, contour), contour, vertex});
}

Ring Operand::one_contour() const {
  if (regions.contour_count() != 1)
    refuse("the operand has " + std::to_string(regions.contour_count()) + " contours, but the method takes one",
           regions.contour_count() > 1 ? 1 : npos, npos);
  Ring ring = clean_ring(regions.contour(0));
  if (ring.size() < 3) refuse("the contour has fewer than three different points", 0, npos);
  return ring;
}

Ring Operand::one_convex_contour() const {
  Ring ring = one_contour();
  int turn = 0;
  const char* why = nullptr;
  const std::size_t at = first_not_convex(ring, turn, why);
  if (at != npos) refuse(why, 0, ring.source[at]);
  if (turn < 0) reverse(ring);
  return ring;
}

Array<Ring> Operand::all_contours() const {
  Array<Ring> rings;
  rings.reserve(regions.contour_count());
  for (std::size_t c = 0; c < regions.contour_count(); ++c) {
    rings.push_back(clean_ring(regions.contour(c)));
    rings.back().contour = c;
    if (rings.back().size() < 3) refuse("the contour has fewer than three different points", c, npos);
  }
  return rings;
}

void refuse_symmetric_difference(bool is_symmetric_difference, const char* method) {
  if (is_symmetric_difference)
    throw Error(ErrorCode::precondition,
                std::string(method) + ": the method has no symmetric difference; use overlay instead");
}

}  // namespace oblast::internal::classics
