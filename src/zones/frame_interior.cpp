#include "zones/frame_interior.h"

#include <algorithm>
#include <utility>

#include "exact/orientation.h"

namespace oblast::internal::zoning {
namespace {

/// Whether the segment meets the box. REQUIRES: its own box does.
bool meets(const Point& from, const Point& to, const Box& box) {
  const Point corners[] = {{box.x0, box.y0}, {box.x1, box.y0}, {box.x1, box.y1}, {box.x0, box.y1}};
  bool left = false, right = false;
  for (const Point& corner : corners) {
    const int side = exact::orientation(from, to, corner);
    left = left || side >= 0;
    right = right || side <= 0;
  }
  return left && right;
}

template <class Edge>
Array<Box> boxes_of(const LargeArray<Edge>& edges) {
  Array<Box> boxes;
  boxes.reserve(edges.size());
  for (const Edge& e : edges) boxes.push_back(Box::of(e.from, e.to));
  return boxes;
}

}  // namespace

LargeArray<FrameInterior::Edge> FrameInterior::edges_of(const RegionView& frame) {
  LargeArray<Edge> edges;
  edges.reserve(frame.points.size());
  for (const std::span<const Point> ring : frame.contours())
    for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]});
  return edges;
}

FrameInterior::FrameInterior(const RegionView& frame) : FrameInterior(frame, edges_of(frame)) {}

FrameInterior::FrameInterior(const RegionView& frame, LargeArray<Edge> edges)
    : edges_(std::move(edges)), boxes_(boxes_of(edges_)), regions_(frame) {}

bool FrameInterior::holds(const Box& box) const {
  const bool is_clear =
      boxes_.for_each_near(box, [&](std::uint32_t e) { return !meets(edges_[e].from, edges_[e].to, box); });
  return is_clear && regions_.locate({box.x0, box.y0}) == Location::inside;
}

}  // namespace oblast::internal::zoning
