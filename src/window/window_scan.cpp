// What comes near the window: block by block, most of the subject needs a look at its boxes only.
#include <algorithm>
#include <cmath>

#include "exact/intersection_point.h"
#include "exact/orientation.h"
#include "noding/simple_ring.h"
#include "plane/far.h"
#include "window/window_clip.h"

namespace oblast::internal::window {

using exact::orientation;

SubjectKind kind_of(const RegionView& operand) {
  if (operand.contour_count() != 1) return SubjectKind::any;
  const auto contour = without_closing_point(operand.contour(0));
  return contour.size() >= 3 && convex_turn(contour) != 0 ? SubjectKind::convex : SubjectKind::any;
}

WindowClip::WindowClip(const RegionView& subject, SubjectKind kind, const Window& window,
                       std::pmr::memory_resource* memory)
    : subject_(subject),
      kind_(kind),
      window_(window),
      rings_(memory),
      blocks_(memory),
      covers_(memory),
      stretches_(memory),
      crossings_(memory),
      perimeter_(memory),
      polygons_(memory) {}

/// Rings, their blocks, and the gap.
void WindowClip::measure() {
  rings_.reserve(subject_.contour_count());
  blocks_.reserve(subject_.points.size() / block_size + subject_.contour_count());
  covers_.assign(subject_.polygon_count(), 0);
  Box all = window_.box();
  for (Index p = 0; p < subject_.polygon_count(); ++p) {
    for (Index c = subject_.polygon_begin(p); c < subject_.polygon_end(p); ++c) {
      const auto points = without_closing_point(subject_.contour(c));
      if (points.size() < 3) continue;
      rings_.push_back({points, subject_.contour_begin(c), p, static_cast<Index>(blocks_.size())});
      const Index n = rings_.back().size();
      for (Index first = 0; first < n; first += block_size) {
        const Index last = std::min(first + block_size, n);
        const Point& end = last == n ? points[0] : points[last];
        // Two boxes at once: neither need wait for the other's last comparison.
        Box even = Box::of(end, end), odd = even;
        for (Index i = first; i + 1 < last; i += 2) {
          even = even.joined(points[i]);
          odd = odd.joined(points[i + 1]);
        }
        even = even.joined(points[last - 1]);
        blocks_.push_back(even.joined(odd));
        all = all.joined(blocks_.back());
      }
    }
  }
  gap_ = clearance_gap(std::max({-all.x0, -all.y0, all.x1, all.y1, std::fabs(all.x0), std::fabs(all.y0)}));
}

/// The reach, and the parity of every polygon. False when nothing comes near.
bool WindowClip::find_reach(Operation operation) {
  const Box near = window_.box().widened(gap_);
  const Point ray = window_.corner(0);  // upward from here
  bool any = operation != Operation::intersection;
  Box reach = near;
  for (const Ring& ring : rings_) {
    for (Index first = 0, b = ring.first_block; first < ring.size(); first += block_size, ++b) {
      const Index last = std::min(first + block_size, ring.size());
      const Box& block = blocks_[b];
      if (block.x0 <= ray.x && block.x1 > ray.x && block.y1 > ray.y) count_parity(ring, first, last);
      if (operation != Operation::intersection) {
        reach = reach.joined(block);
        continue;
      }
      if (!near.meets(block)) continue;
      for (Index i = first; i < last; ++i) {
        const Box edge = Box::of(ring.from(i), ring.to(i));
        if (!near.meets(edge)) continue;
        any = true;
        reach = reach.joined(edge);
      }
    }
  }
  reach_ = reach.widened(gap_);
  return any;
}

void WindowClip::count_parity(const Ring& ring, Index first, Index last) {
  const Point ray = window_.corner(0);
  bool odd = false;
  for (Index i = first; i < last; ++i) {
    const Point &p = ring.from(i), &q = ring.to(i);
    if ((p.x <= ray.x) == (q.x <= ray.x)) continue;
    odd ^= orientation(p, q, ray) == (p.x < q.x ? -1 : 1);
  }
  covers_[ring.polygon] ^= static_cast<std::uint8_t>(odd);
}

/// All crossings, and the stretches near the window. False when declined.
bool WindowClip::walk() {
  for (Index r = 0; r < rings_.size(); ++r) {
    Ring& ring = rings_[r];
    ring.first_crossing = static_cast<Index>(crossings_.size());
    bool inside = window_.contains(ring.points[0]);
    ring.inside = inside;
    for (Index first = 0, b = ring.first_block; first < ring.size(); first += block_size, ++b)
      if (reach_.meets(blocks_[b]) && !walk_block(r, first, std::min(first + block_size, ring.size()), inside))
        return false;
    ring.end_crossing = static_cast<Index>(crossings_.size());
    ring.inside &= ring.first_crossing == ring.end_crossing;
  }
  return true;
}

bool WindowClip::walk_block(Index r, Index first, Index last, bool& inside) {
  const Ring& ring = rings_[r];
  for (Index i = first; i < last; ++i) {
    if (!reach_.meets(Box::of(ring.from(i), ring.to(i)))) continue;
    const std::size_t before = crossings_.size();
    if (!cross_window(r, i)) return false;
    const std::size_t found = crossings_.size() - before;
    if (found == 1 && crossings_[before].enters == inside) return false;
    const bool core = found > 0 || (inside && kind_ == SubjectKind::any);
    if (stretches_.empty() || stretches_.back().ring != r || stretches_.back().last != i ||
        stretches_.back().core != core)
      stretches_.push_back({r, i, i, core});
    stretches_.back().last = i + 1;
    inside ^= found == 1;
  }
  return true;
}

/// Adds the proper crossings of an edge with the window, the first one along the edge first. False when it comes too
/// near a corner, or one of its ends a side.
bool WindowClip::cross_window(Index r, Index edge) {
  const Ring& ring = rings_[r];
  const Point &p = ring.from(edge), &q = ring.to(edge);
  const std::size_t before = crossings_.size();
  const bool clear = window_.each_side_near(Box::of(p, q).widened(gap_), [&](Index side) {
    const Point &c = window_.corner(side), &d = window_.corner_after(side);
    if (!is_far(p, c, d, gap_) || !is_far(q, c, d, gap_) || !is_far(c, p, q, gap_) || !is_far(d, p, q, gap_))
      return false;
    const int p_side = orientation(c, d, p);
    if (p_side * orientation(c, d, q) >= 0 || orientation(p, q, c) * orientation(p, q, d) >= 0) return true;
    const Point x = exact::intersection_point(p, q, c, d);
    if (!is_clear_at(x, side, ring, edge)) return false;
    crossings_.push_back({x, side, r, edge, p_side < 0, false});
    return true;
  });
  const std::size_t found = crossings_.size() - before;
  if (!clear || found > 2) return false;
  if (found == 2) {
    if (crossings_[before].enters == crossings_[before + 1].enters) return false;
    if (!crossings_[before].enters) std::swap(crossings_[before], crossings_[before + 1]);
  }
  return true;
}

/// The rounded crossing keeps clear of all but the two edges that cross there, and the side of corners that are not
/// its own. (Of A's other edges only the neighbours can come nearer to x than to the whole edge.)
bool WindowClip::is_clear_at(const Point& x, Index side, const Ring& ring, Index edge) const {
  const Point &c = window_.corner(side), &d = window_.corner_after(side);
  const bool sides_are_far = window_.each_side_near(Box::of(x, x).widened(gap_), [&](Index s) {
    return s == side || is_far(x, window_.corner(s), window_.corner_after(s), gap_);
  });
  if (!sides_are_far) return false;
  const Box side_box = Box::of(c, d).widened(gap_);
  for (Index s = 0; s < window_.size(); ++s) {
    const Point& corner = window_.corner(s);
    if (side_box.meets(Box::of(corner, corner)) && corner != c && corner != d && !is_far(corner, c, d, gap_))
      return false;
  }
  const Index before = edge == 0 ? ring.size() - 1 : edge - 1, after = ring.after(edge);
  return is_far(x, ring.from(before), ring.to(before), gap_) && is_far(x, ring.from(after), ring.to(after), gap_);
}

}  // namespace oblast::internal::window
