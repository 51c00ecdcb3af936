#include "buffer/line_walks.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace oblast::internal::buffering {
namespace {

/// The closed path, from where it is lexicographically smallest. Two candidates are compared, and the larger one skips
/// what was equal, so the time is linear (Shiloach 1981).
void begin_at_smallest(Array<Point>& path) {
  path.pop_back();
  const std::size_t size = path.size();
  std::size_t i = 0, j = 1, equal = 0;
  while (i < size && j < size && equal < size) {
    const Point p = path[(i + equal) % size], q = path[(j + equal) % size];
    if (p == q) {
      ++equal;
      continue;
    }
    (lexicographically_less(p, q) ? j : i) += equal + 1;
    if (i == j) ++j;
    equal = 0;
  }
  std::rotate(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(std::min(i, j)), path.end());
  path.push_back(path.front());
}

/// The path or its reverse, whichever is lexicographically smaller.
void turn(Array<Point>& path, bool closed) {
  Array<Point> back(path.rbegin(), path.rend());
  if (closed) begin_at_smallest(back);
  if (std::lexicographical_compare(back.begin(), back.end(), path.begin(), path.end(), lexicographically_less))
    path = std::move(back);
}

/// A walk along the path the other way. Edge i leads from vertex i to i + 1, so edges move by one.
Walk reversed(const Walk& walk) {
  Walk back(walk.rbegin(), walk.rend());
  for (std::size_t i = 0; i + 1 < back.size(); ++i) back[i].edge = back[i + 1].edge;
  return back;
}

/// There and back. REQUIRES: both begin and end at the same points.
Walk around(const Walk& right, const Walk& left) {
  Walk walk = right;
  walk.front().corner = Corner::end;
  const Walk back = reversed(left);
  walk.back() = back.front();
  walk.back().corner = Corner::end;
  walk.insert(walk.end(), back.begin() + 1, back.end() - 1);
  return walk;
}

/// Offset on the right only: there with offsets, and back without.
Array<Walk> one_sided(const Array<Point>& path, bool closed) {
  Walk there = plain_walk(path), back;
  for (std::size_t i = path.size(); i-- > 0;) back.push_back({path[i], WalkEdge::bare, Corner::bare});
  if (closed) {
    there.pop_back(), back.pop_back();
    return {std::move(there), std::move(back)};
  }
  there.front().corner = Corner::bare;
  there.back() = back.front();
  there.insert(there.end(), back.begin() + 1, back.end() - 1);
  return {std::move(there)};
}

/// The inner points of the path with pockets closed. The first and the last edge stay, for they give caps their
/// direction.
ClosedPath close_between_ends(const Array<Point>& path, double widest) {
  if (path.size() <= 4) return {plain_walk(path), plain_walk(path)};
  ClosedPath inner = close_pockets(std::span(path).subspan(1, path.size() - 2), widest, true);
  for (Walk* const walk : {&inner.right, &inner.left}) {
    walk->back().edge = WalkEdge::offset;
    walk->insert(walk->begin(), {path.front()});
    walk->push_back({path.back()});
  }
  return inner;
}

}  // namespace

Array<Point> line_path(std::span<const Point> line, Side side) {
  Array<Point> path;
  for (const Point& p : line) {
    const Point positive{p.x + 0.0, p.y + 0.0};  // without a negative zero
    if (path.empty() || !(path.back() == positive)) path.push_back(positive);
  }
  if (path.size() < 2) return path;
  const bool closed = path.front() == path.back();
  if (closed) begin_at_smallest(path);
  if (side == Side::both) turn(path, closed);
  if (side == Side::left) std::reverse(path.begin(), path.end());
  return path;
}

Array<Walk> line_walks(const Array<Point>& path, Side side, Cap cap, double widest_lid, std::uint64_t& pockets) {
  const bool closed = path.front() == path.back();
  if (side != Side::both) return one_sided(path, closed);
  ClosedPath sides;
  if (widest_lid == 0)
    sides = {plain_walk(path), plain_walk(path)};
  else if (closed || cap == Cap::round)
    sides = close_pockets(path, widest_lid, true);
  else
    sides = close_between_ends(path, widest_lid);
  pockets += sides.pockets;
  Array<Walk> walks;
  if (!closed) {
    walks.push_back(around(sides.right, sides.left));
    return walks;
  }
  walks.push_back(std::move(sides.right));
  walks.push_back(reversed(sides.left));
  for (Walk& walk : walks) walk.pop_back();
  return walks;
}

}  // namespace oblast::internal::buffering
