// One clip by the half-plane left of a line L:
//
//         \  path  /    \  path  /         paths left of L remain; everything on L or right of it is dropped
//   L  ----x------o------x------o---->     path ends are sorted along L; at one point they are sorted by angle, in
//        exit   entry  exit   entry        the order in which a line just left of L meets them
//
// Along a line just left of L, the subject's interior is between the first and the second path end, between the third
// and the fourth, and so on. There a new edge runs along L from an exit to an entry. Vertices on L inside such an edge
// are inserted into it. So no two edges overlap on L. (They do overlap if ends are joined in the order of the walk:
// these are the "bridges" of the method without the sort.)
#include "classics/half_plane_clip.h"

#include <algorithm>
#include <cmath>

#include "base/call_memory.h"
#include "base/index.h"
#include "exact/orientation.h"

namespace oblast::internal::classics {
namespace {

using exact::orientation;

bool is_safe(double coordinate) {
  const double magnitude = std::fabs(coordinate);
  return magnitude == 0 || (magnitude >= crossing_smallest && magnitude <= crossing_largest);
}

int compare_points(const Point& p, const Point& q, const Line& line) {
  if (p == q) return 0;
  return lexicographically_less(p, q) == lexicographically_less(line.p, line.q) ? -1 : 1;
}

Line reversed(const Line& line) { return {line.q, line.p}; }

}  // namespace

ConvexWindow::ConvexWindow(Ring convex) : ring(std::move(convex.points)), low(ring[0]), high(ring[0]) {
  const std::size_t n = ring.size();
  std::size_t corner = 0;
  const auto is_corner = [&](std::size_t i) {
    return orientation(ring[(i + n - 1) % n], ring[i % n], ring[(i + 1) % n]) != 0;
  };
  while (!is_corner(corner)) ++corner;
  std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(corner), ring.end());
  for (std::size_t i = 0; i < n;) {
    std::size_t end = i + 1;
    while (end < n && !is_corner(end)) ++end;
    sides.push_back({ring[i], ring[end % n]});
    straight.emplace_back(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                          ring.begin() + static_cast<std::ptrdiff_t>(end));
    i = end;
  }
  for (const Point& p : ring) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    safe_magnitudes &= is_safe(p.x) && is_safe(p.y);
  }
}

HalfPlaneClip::HalfPlaneClip(std::span<const Ring> subject, const ConvexWindow& window) : window_(window) {
  std::size_t size = 0;
  for (const Ring& ring : subject) size += ring.size();
  check_count(size + window.sides.size(), "edges of subject and window");
  edges_.reserve(size);
  vertices_.reserve(size);
  for (const Ring& ring : subject) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      vertices_.push_back({ring.points[i], subject_edges()});
      edges_.push_back({ring.points[i], ring.next(i)});
    }
    ends_.push_back(subject_edges());
  }
  touches_.resize(window.sides.size());
}

Line HalfPlaneClip::line(std::uint32_t id) const {
  return id < edges_.size() ? edges_[id] : window_.sides[id - edges_.size()];
}

bool HalfPlaneClip::run() {
  for (std::uint32_t side = 0; side < window_.sides.size(); ++side)
    if (!clip(side)) return false;
  return true;
}

int HalfPlaneClip::side_of(const ClipVertex& v, std::uint32_t side) const {
  const Line& l = window_.sides[side];
  if (!v.is_crossing()) return orientation(l.p, l.q, v.at);
  const std::uint32_t id = subject_edges() + side;
  if (v.first == id || v.second == id) return 0;
  return side_of_crossing(line(v.first), line(v.second), l);
}

/// The point at which an edge crosses the line of a side. If the edge passes exactly through a corner, that corner.
ClipVertex HalfPlaneClip::cross(std::uint32_t edge, std::uint32_t side) const {
  const Line e = line(edge);
  for (const Point& corner : {window_.sides[side].p, window_.sides[side].q})
    if (orientation(e.p, e.q, corner) == 0) return {corner, edge};
  return {{}, edge, edge, subject_edges() + side};
}

/// For a crossing on the line of a side: another line through the crossing.
std::uint32_t HalfPlaneClip::other_line(const ClipVertex& v, std::uint32_t side) const {
  const std::uint32_t id = subject_edges() + side;
  if (v.first == id) return v.second;
  if (v.second == id) return v.first;
  return std::max(v.first, v.second);  // another side's line; the subject's edge may run along this one
}

/// The order of two vertices on the line of a side, in its direction.
int HalfPlaneClip::compare_along(const ClipVertex& v, const ClipVertex& w, std::uint32_t side) const {
  const Line& l = window_.sides[side];
  if (!v.is_crossing() && !w.is_crossing()) return compare_points(v.at, w.at, l);
  if (!w.is_crossing()) return -compare_along(w, v, side);
  // If a line turns left from L, points further along L are on its right.
  const Line e = line(other_line(w, side));
  const int v_side = v.is_crossing() ? side_of_crossing(l, line(other_line(v, side)), e) : orientation(e.p, e.q, v.at);
  return -v_side * turn(l, e);
}

bool HalfPlaneClip::clip(std::uint32_t side) {
  path_vertices_.clear();
  kept_.clear();
  kept_ends_.clear();
  paths_.clear();
  path_ends_.clear();
  on_line_ = window_.straight[side];
  std::uint32_t begin = 0;
  for (const std::uint32_t end : ends_) {
    split(begin, end, side);
    begin = end;
  }
  if (!join(side)) return false;
  vertices_.swap(kept_);
  ends_.swap(kept_ends_);
  return true;
}

/// Divides one contour into its paths left of the line.
void HalfPlaneClip::split(std::uint32_t begin, std::uint32_t end, std::uint32_t side) {
  if (begin == end) return;
  const std::uint32_t n = end - begin;
  sides_.resize(n);
  for (std::uint32_t i = 0; i < n; ++i) sides_[i] = side_of(vertices_[begin + i], side);
  const auto at = [&](std::uint32_t i) -> const ClipVertex& { return vertices_[begin + i % n]; };
  const auto is_left = [&](std::uint32_t i) { return sides_[i % n] > 0; };
  for (std::uint32_t i = 0; i < n; ++i) {
    if (sides_[i] != 0 || at(i).is_crossing()) continue;
    touches_[side].push_back(at(i).at);
    on_line_.push_back(at(i).at);
  }
  std::uint32_t start = 0;
  while (start < n && !(is_left(start + 1) && !is_left(start))) ++start;
  if (start == n) {
    if (!is_left(0)) return;
    kept_.insert(kept_.end(), vertices_.begin() + begin, vertices_.begin() + end);
    kept_ends_.push_back(checked_index(kept_.size(), "vertices of the clipped subject"));
    return;
  }
  for (std::uint32_t i = start; i < start + n;) {
    if (is_left(i) || !is_left(i + 1)) {
      ++i;
      continue;
    }
    Path path{static_cast<std::uint32_t>(path_vertices_.size()), 0};
    path_vertices_.push_back(sides_[i % n] == 0 ? at(i) : cross(at(i).along, side));
    for (++i; is_left(i); ++i) path_vertices_.push_back(at(i));
    path_vertices_.push_back(sides_[i % n] == 0 ? at(i) : cross(at(i - 1 + n).along, side));
    path.end = checked_index(path_vertices_.size(), "vertices of the clipped subject");
    paths_.push_back(path);
    add_path_end(static_cast<std::uint32_t>(paths_.size() - 1), true);
    add_path_end(static_cast<std::uint32_t>(paths_.size() - 1), false);
  }
}

void HalfPlaneClip::add_path_end(std::uint32_t path, bool entry) {
  const Path& p = paths_[path];
  if (entry)
    path_ends_.push_back({path_vertices_[p.begin], line(path_vertices_[p.begin].along), path, true});
  else
    path_ends_.push_back({path_vertices_[p.end - 1], reversed(line(path_vertices_[p.end - 2].along)), path, false});
}

/// Joins the paths to contours, with new edges along the line.
bool HalfPlaneClip::join(std::uint32_t side) {
  const std::uint32_t id = subject_edges() + side;
  std::sort(path_ends_.begin(), path_ends_.end(), [&](const PathEnd& v, const PathEnd& w) {
    const int order = compare_along(v.vertex, w.vertex, side);
    return order != 0 ? order < 0 : turn(v.ray, w.ray) < 0;
  });
  const Line& l = window_.sides[side];
  std::sort(on_line_.begin(), on_line_.end(),
            [&](const Point& p, const Point& q) { return compare_points(p, q, l) < 0; });
  on_line_.erase(std::unique(on_line_.begin(), on_line_.end()), on_line_.end());

  Array<std::uint32_t> exit_of(paths_.size(), none);  // by path: index of its exit in path_ends_
  for (std::uint32_t i = 0; i < path_ends_.size(); ++i) {
    if (path_ends_[i].entry != (i % 2 == 1)) return false;
    if (!path_ends_[i].entry) exit_of[path_ends_[i].path] = i;
  }
  const auto first_after = [&](const ClipVertex& v) {
    return std::partition_point(on_line_.begin(), on_line_.end(),
                                [&](const Point& p) { return compare_along({p}, v, side) <= 0; });
  };
  Array<bool> done(paths_.size(), false);
  for (std::uint32_t start = 0; start < paths_.size(); ++start) {
    if (done[start]) continue;
    for (std::uint32_t path = start; !done[path];) {
      done[path] = true;
      kept_.insert(kept_.end(), path_vertices_.begin() + paths_[path].begin,
                   path_vertices_.begin() + paths_[path].end - 1);
      const PathEnd &exit = path_ends_[exit_of[path]], &entry = path_ends_[exit_of[path] + 1];
      if (compare_along(exit.vertex, entry.vertex, side) != 0) {
        kept_.push_back(exit.vertex);
        kept_.back().along = id;
        for (auto p = first_after(exit.vertex); p != on_line_.end() && compare_along({*p}, entry.vertex, side) < 0; ++p)
          kept_.push_back({*p, id});
      }
      path = entry.path;
    }
    kept_ends_.push_back(checked_index(kept_.size(), "vertices of the clipped subject"));
  }
  return true;
}

}  // namespace oblast::internal::classics
