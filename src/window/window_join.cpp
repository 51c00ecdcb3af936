// From crossings to the result.
#include <algorithm>
#include <numeric>
#include <vector>

#include "base/call_memory.h"
#include "base/index.h"
#include "base/memory_budget.h"
#include "noding/simple_ring.h"
#include "window/contours.h"
#include "window/window_clip.h"

namespace oblast::internal::window {

std::optional<RegionSet> WindowClip::run(Operation operation, RegionSet* spare) {
  measure();
  const bool reaches = find_reach(operation);
  if (reaches && (!walk() || !order_along_perimeter() || !core_is_clear())) return {};
  RegionSet result;
  if (spare) result = std::move(*spare);
  result.points.clear();
  result.contour_ends.clear();
  if (reaches) join(operation, result);
  if (crossings_.empty() && std::accumulate(covers_.begin(), covers_.end(), 0) > 1 &&
      std::any_of(rings_.begin(), rings_.end(), is_inside))
    return {};
  if (operation == Operation::intersection)
    add_uncrossed(result);
  else if (crossings_.empty())
    add_uncrossed_pair(operation, result);
  const Charge charge(2 * bytes_of(result));  // with the one in order
  return finish(operation, std::move(result));
}

/// Sorts the crossings and tells where the inside of the subject ends and begins. False when two were rounded to one
/// place, or polygons overlap.
bool WindowClip::order_along_perimeter() {
  const auto count = static_cast<Index>(crossings_.size());
  perimeter_.resize(count);
  std::iota(perimeter_.begin(), perimeter_.end(), Index{0});
  // Rounding is monotone, so rounded points keep their order along a side in each coordinate.
  std::sort(perimeter_.begin(), perimeter_.end(), [&](Index i, Index j) {
    const Crossing &v = crossings_[i], &w = crossings_[j];
    if (v.side != w.side) return v.side < w.side;
    const Point &c = window_.corner(v.side), &d = window_.corner_after(v.side);
    return v.at.x != w.at.x ? (v.at.x < w.at.x) == (c.x < d.x) : v.at.y != w.at.y && (v.at.y < w.at.y) == (c.y < d.y);
  });
  int coverage = std::accumulate(covers_.begin(), covers_.end(), 0);
  if (coverage > 1 && count > 0) return false;
  for (Index k = 0; k < count; ++k) {
    Crossing& c = crossings_[perimeter_[k]];
    std::uint8_t& covers = covers_[rings_[c.ring].polygon];
    c.inside_ends = covers != 0;
    covers ^= 1;
    coverage += covers != 0 ? 1 : -1;
    if (coverage > 1 || (k > 0 && c.at == crossings_[perimeter_[k - 1]].at)) return false;
    c.position = k;
  }
  // Along a path the inside stays on one side.
  for (const Ring& ring : rings_)
    for (Index k = ring.first_crossing; k < ring.end_crossing; ++k)
      if ((crossings_[k].enters == crossings_[k].inside_ends) !=
          (crossings_[ring.first_crossing].enters == crossings_[ring.first_crossing].inside_ends))
        return false;
  return true;
}

void WindowClip::join(Operation operation, RegionSet& result) {
  std::size_t size = 2 * crossings_.size() + window_.size();
  for (const Stretch& s : stretches_) size += s.core || kind_ == SubjectKind::convex ? s.last - s.first : 0;
  result.points.reserve(size);
  const bool inside_paths = operation == Operation::intersection, along = operation != Operation::difference;
  const auto count = static_cast<Index>(perimeter_.size());
  for (const Index start : perimeter_) {
    if (crossings_[start].done || crossings_[start].inside_ends != inside_paths) continue;
    for (Index k = start; !crossings_[k].done;) {
      Crossing& from = crossings_[k];
      from.done = true;
      const Ring& ring = rings_[from.ring];
      const bool forward = from.enters == from.inside_ends;
      const Index first = ring.first_crossing, end = ring.end_crossing;
      const Crossing& to = crossings_[forward ? (k + 1 == end ? first : k + 1) : (k == first ? end : k) - 1];
      add_path(from, forward, to, result);
      const Index next =
          along ? (to.position + 1 == count ? 0 : to.position + 1) : (to.position == 0 ? count : to.position) - 1;
      k = perimeter_[next];
      add_perimeter(to, crossings_[k], along, result);
    }
    // No two polygons cover a place of the perimeter, so all of its paths are of one polygon.
    end_contour(rings_[crossings_[start].ring].polygon, result);
  }
}

/// A crossing, the vertices of its ring up to the next crossing, and that.
void WindowClip::add_path(const Crossing& from, bool forward, const Crossing& to, RegionSet& result) const {
  const Ring& ring = rings_[from.ring];
  const Index n = ring.size();
  result.points.push_back(from.at);
  const auto add = [&](const Point& p) { result.points.push_back({p.x + 0.0, p.y + 0.0}); };
  // On one edge the path is all of the ring's vertices when it leads against the direction of its ends.
  const bool goes_round = from.edge == to.edge && forward != from.enters;
  if (forward) {
    for (Index i = from.edge, left = goes_round ? n : (to.edge + n - from.edge) % n; left > 0; --left)
      add(ring.points[i = ring.after(i)]);
  } else {
    for (Index i = from.edge, left = goes_round ? n : (from.edge + n - to.edge) % n; left > 0; --left) {
      add(ring.points[i]);
      i = i == 0 ? n - 1 : i - 1;
    }
  }
  result.points.push_back(to.at);
}

/// The window's corners between two crossings.
void WindowClip::add_perimeter(const Crossing& from, const Crossing& to, bool forward, RegionSet& result) const {
  const Index m = window_.size();
  const bool wraps = forward ? to.position <= from.position : to.position >= from.position;
  if (from.side == to.side && !wraps) return;
  Index s = from.side;
  if (forward) {
    do {
      s = s + 1 == m ? 0 : s + 1;
      result.points.push_back(window_.corner(s));
    } while (s != to.side);
  } else {
    do {
      result.points.push_back(window_.corner(s));
      s = s == 0 ? m - 1 : s - 1;
    } while (s != to.side);
  }
}

/// Of an intersection: the window where no boundary meets it, and rings inside it.
void WindowClip::add_uncrossed(RegionSet& result) {
  const auto cover = std::find(covers_.begin(), covers_.end(), 1);
  if (crossings_.empty() && cover != covers_.end())
    add_window(true, static_cast<Index>(cover - covers_.begin()), result);
  const bool alone = result.contour_ends.empty() && std::count_if(rings_.begin(), rings_.end(), is_inside) == 1;
  for (const Ring& ring : rings_) {
    // The first ring of a polygon is its outer one, the others are holes in it; where not, finish() will see.
    const bool first = ring.offset == subject_.contour_begin(subject_.polygon_begin(ring.polygon));
    if (ring.inside) add_ring(ring, first || alone, result);
  }
}

/// Of the other operations on two convex contours.
void WindowClip::add_uncrossed_pair(Operation operation, RegionSet& result) {
  const Ring& ring = rings_[0];
  const bool a_in_window = ring.inside, window_in_a = covers_[0] != 0, unite = operation == Operation::unite;
  if (!a_in_window) add_ring(ring, true, result);
  if (unite ? !window_in_a : window_in_a) add_window(unite, ring.polygon, result);
}

/// Canonical order. Nothing when polygons overlap after all.
std::optional<RegionSet> WindowClip::finish(Operation operation, RegionSet result) const {
  const auto less = lexicographically_less;
  std::vector<Index> ends = std::move(result.contour_ends);
  Index begin = 0;
  Array<std::span<Point>> contours;
  for (const Index end : ends) {
    contours.push_back(std::span(result.points).subspan(begin, end - begin));
    begin = end;
  }
  // Of one ring no two contours nest, but for a window taken out of its inside.
  const bool outer = ends.size() == 1 || (rings_.size() == 1 && (!crossings_.empty() || operation == Operation::unite));
  if (!outer) {
    Contours loose;
    for (std::size_t k = 0; k < contours.size(); ++k) {
      for (const Point& p : contours[k]) loose.add(p);
      loose.close(polygons_[k]);
    }
    return loose.to_region_set_if_regular();
  }
  for (const auto& contour : contours)
    std::rotate(contour.begin(), std::min_element(contour.begin(), contour.end(), less), contour.end());
  if (contours.size() == 1) {
    result.contour_ends = std::move(ends);
    result.polygon_ends.assign(1, 1);
    return result;
  }
  RegionSet sorted;
  std::sort(contours.begin(), contours.end(), [&](const auto& c, const auto& d) { return less(c[0], d[0]); });
  sorted.points.reserve(result.points.size());
  sorted.contour_ends.reserve(contours.size());
  sorted.polygon_ends.resize(contours.size());
  std::iota(sorted.polygon_ends.begin(), sorted.polygon_ends.end(), Index{1});
  for (const auto& contour : contours) {
    sorted.points.insert(sorted.points.end(), contour.begin(), contour.end());
    sorted.contour_ends.push_back(checked_index(sorted.points.size(), "vertices of the result", most_vertices));
  }
  return sorted;
}

void WindowClip::add_ring(const Ring& ring, bool counter_clockwise, RegionSet& result) {
  const bool reversed = (turn_at_smallest(ring.points) > 0) != counter_clockwise;
  const Index n = ring.size();
  for (Index i = 0; i < n; ++i) {
    const Point& p = ring.points[reversed ? n - 1 - i : i];
    result.points.push_back({p.x + 0.0, p.y + 0.0});
  }
  end_contour(ring.polygon, result);
}

void WindowClip::add_window(bool counter_clockwise, Index polygon, RegionSet& result) {
  for (Index i = 0; i < window_.size(); ++i)
    result.points.push_back(window_.corner(counter_clockwise ? i : window_.size() - 1 - i));
  end_contour(polygon, result);
}

void WindowClip::end_contour(Index polygon, RegionSet& result) {
  result.contour_ends.push_back(checked_index(result.points.size(), "vertices of the result", most_vertices));
  polygons_.push_back(polygon);
}

}  // namespace oblast::internal::window
