#include "zones/frame_interior.h"

#include "base/large_pages.h"
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

Array<Box> boxes_of(const locate::Edges& edges) {
  Array<Box> boxes;
  boxes.reserve(edges.edges.size());
  for (const locate::Index e : edges.edges) boxes.push_back(Box::of(edges.from(e), edges.to(e)));
  return boxes;
}

}  // namespace

FrameInterior::FrameInterior(const RegionView& frame)
    : charge_(locate::Edges::bytes(frame)),
      edges_(locate::edges_of(frame)),
      boxes_(boxes_of(edges_)),
      regions_(edges_) {}

bool FrameInterior::holds(const Box& box) const {
  const bool is_clear = boxes_.for_each_near(
      box, [&](std::uint32_t e) { return !meets(edges_.from(edges_.edges[e]), edges_.to(edges_.edges[e]), box); });
  return is_clear && regions_.locate({box.x0, box.y0}) == Location::inside;
}

}  // namespace oblast::internal::zoning
