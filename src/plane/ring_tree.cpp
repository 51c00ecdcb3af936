#include "plane/ring_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "base/call.h"
#include "base/call_memory.h"
#include "base/tuning.h"
#include "exact/orientation.h"
#include "plane/edges_in.h"

namespace oblast::internal {
namespace {

using exact::orientation;

Box common_box(const Box& p, const Box& q) {
  return {std::max(p.x0, q.x0), std::max(p.y0, q.y0), std::min(p.x1, q.x1), std::min(p.y1, q.y1)};
}

/// True if two closed segments have a point in common. REQUIRES: their boxes meet.
bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (orientation(a, b, c) * orientation(a, b, d) > 0) return false;
  return orientation(c, d, a) * orientation(c, d, b) <= 0;
}

/// True if the path u -- v -- w folds back onto itself.
bool folds(const Point& u, const Point& v, const Point& w) {
  return lexicographically_less(u, v) != lexicographically_less(v, w) && orientation(u, v, w) == 0;
}

/// The directions, out of eight around, along which an edge certainly advances: one bit each.
std::uint8_t directions_of(const Point& a, const Point& b) {
  const double x = b.x - a.x, y = b.y - a.y;
  // More than the rounding error of a sum.
  const double safe = 0x1p-40 * (std::fabs(x) + std::fabs(y));
  const double rising = x + y, falling = x - y;
  const unsigned diagonals = static_cast<unsigned>(rising > safe) | static_cast<unsigned>(rising < -safe) << 1 |
                             static_cast<unsigned>(falling > safe) << 2 | static_cast<unsigned>(falling < -safe) << 3;
  return static_cast<std::uint8_t>(heading(a, b) | diagonals << 4);
}

constexpr std::uint32_t longest_leaf = tuning::longest_ring_leaf;

// A depth-first walk leaves at most three neighbours behind on each of 32 levels.
constexpr std::size_t stack_size = 128;

}  // namespace

void RingTree::build(std::span<const Point> points, std::span<const std::uint32_t> ends) {
  points_ = points;
  ends_ = ends;
  leaves_.clear();
  boxes_.clear();
  directions_.clear();
  first_leaves_.clear();
  for (std::uint32_t ring = 0; ring < ends.size(); ++ring) {
    first_leaves_.push_back(static_cast<std::uint32_t>(leaves_.size()));
    add_leaves(ring, begin(ring), ends[ring] - 1);
  }
  first_leaves_.push_back(static_cast<std::uint32_t>(leaves_.size()));
  add_levels();
}

void RingTree::add_leaves(std::uint32_t ring, std::uint32_t begin, std::uint32_t last) {
  std::uint8_t next = directions_of(points_[begin], points_[begin + 1]);
  for (std::uint32_t first = begin, past; first < last; first = past) {
    Box box = Box::of(points_[first], points_[first + 1]);
    std::uint8_t directions = next;
    const std::uint32_t most = std::min(first + longest_leaf, last);
    for (past = first + 1; past < last; ++past) {
      next = directions_of(points_[past], points_[past + 1]);
      if (past == most || (directions & next) == 0) break;
      directions &= next;
      box = box.joined(points_[past + 1]);
    }
    leaves_.push_back({first, past, ring});
    boxes_.push_back(box);
    directions_.push_back(directions);
  }
}

void RingTree::add_levels() {
  level_begins_.assign({0, boxes_.size()});
  for (std::uint32_t level = 0; size(level) > 1; ++level) {
    const std::size_t begin = level_begins_[level], end = level_begins_[level + 1];
    for (std::size_t i = begin; i + 1 < end; i += 2) {
      boxes_.push_back(boxes_[i].joined(boxes_[i + 1]));
      const std::size_t left = (i - begin) << level, right = (i + 1 - begin) << level;
      const bool one_ring = leaves_[left].ring == leaves_[right].ring;
      directions_.push_back(one_ring ? directions_[i] & directions_[i + 1] : 0);
    }
    if ((end - begin) % 2 != 0) {
      boxes_.push_back(Box(boxes_[end - 1]));
      directions_.push_back(std::uint8_t(directions_[end - 1]));
    }
    level_begins_.push_back(boxes_.size());
  }
}

std::size_t RingTree::most_looks() const { return tuning::looks_a_ring_leaf * leaves_.size(); }

std::optional<bool> RingTree::edges_meet() const {
  std::array<Pair, stack_size> stack;
  std::size_t on_stack = 0, looks = 0;
  const auto push = [&](std::uint32_t level, std::uint32_t i, std::uint32_t j) {
    if (j >= size(level) || (j <= i + 1 && are_monotone(level, i, j))) return;
    if (i == j || box(level, i).meets(box(level, j))) stack[on_stack++] = {level, i, j};
  };
  push(static_cast<std::uint32_t>(level_begins_.size() - 2), 0, 0);
  Steps steps;
  while (on_stack > 0) {
    steps();
    const auto [level, i, j] = stack[--on_stack];
    if (++looks > most_looks()) return {};
    if (level == 0) {
      if (i != j && leaves_meet(i, j)) return true;
      continue;
    }
    const std::uint32_t below = level - 1;
    push(below, 2 * i, 2 * j);
    push(below, 2 * i, 2 * j + 1);
    if (i != j) push(below, 2 * i + 1, 2 * j);
    push(below, 2 * i + 1, 2 * j + 1);
  }
  return false;
}

/// True if all pieces under i and j are monotone in one direction. REQUIRES: i and j are equal or consecutive.
bool RingTree::are_monotone(std::uint32_t level, std::uint32_t i, std::uint32_t j) const {
  const std::uint8_t* const directions = &directions_[level_begins_[level]];
  if ((directions[i] & directions[j]) == 0) return false;
  return i == j || leaves_[i << level].ring == leaves_[j << level].ring;
}

/// REQUIRES: p < q, and their boxes meet.
bool RingTree::leaves_meet(std::uint32_t p, std::uint32_t q) const {
  static_assert(longest_leaf <= 32);
  const Leaf &leaf = leaves_[p], &other = leaves_[q];
  const Box common = common_box(boxes_[p], boxes_[q]);
  const std::uint32_t near_p = edges_in(common, points_.data(), leaf.first, leaf.last);
  if (near_p == 0) return false;
  const std::uint32_t near_q = edges_in(common, points_.data(), other.first, other.last);
  for (std::uint32_t k = near_p; k != 0; k &= k - 1) {
    const std::uint32_t i = leaf.first + static_cast<std::uint32_t>(std::countr_zero(k));
    const Box edge = Box::of(points_[i], points_[i + 1]);
    for (std::uint32_t l = near_q; l != 0; l &= l - 1) {
      const std::uint32_t j = other.first + static_cast<std::uint32_t>(std::countr_zero(l));
      if (edge.meets(Box::of(points_[j], points_[j + 1])) && edges_meet(i, j, leaf.ring)) return true;
    }
  }
  return false;
}

/// REQUIRES: i < j, and their boxes meet.
bool RingTree::edges_meet(std::uint32_t i, std::uint32_t j, std::uint32_t ring) const {
  const Point &a = points_[i], &b = points_[i + 1], &c = points_[j], &d = points_[j + 1];
  if (j == i + 1) return folds(a, b, d);
  if (i == begin(ring) && j == ends_[ring] - 2) return folds(c, d, b);
  return segments_meet(a, b, c, d);
}

std::optional<Array<bool>> RingTree::odd_depths() const {
  Array<bool> odd(ends_.size());
  std::size_t looks = 0;
  for (std::uint32_t ring = 0; ring < ends_.size(); ++ring) {
    const std::optional<bool> answer = is_odd(ring, looks);
    if (!answer) return {};
    odd[ring] = *answer;
  }
  return odd;
}

/// Counts the edges of other rings that cross a ray to the left from a vertex of this ring.
std::optional<bool> RingTree::is_odd(std::uint32_t ring, std::size_t& looks) const {
  const Point& p = points_[begin(ring)];
  const std::uint32_t own_begin = first_leaves_[ring], own_end = first_leaves_[ring + 1];
  std::array<std::pair<std::uint32_t, std::uint32_t>, stack_size> stack;
  std::size_t on_stack = 0;
  stack[on_stack++] = {static_cast<std::uint32_t>(level_begins_.size() - 2), 0};
  bool odd = false;
  while (on_stack > 0) {
    const auto [level, i] = stack[--on_stack];
    if (++looks > most_looks()) return {};
    const Box& b = box(level, i);
    if (b.x0 > p.x || b.y0 > p.y || b.y1 <= p.y) continue;
    const std::uint32_t first = i << level;
    const auto end =
        static_cast<std::uint32_t>(std::min<std::uint64_t>((std::uint64_t{i} + 1) << level, leaves_.size()));
    if (first >= own_begin && end <= own_end) continue;
    if (b.x1 < p.x && (end <= own_begin || first >= own_end)) {
      odd ^= left_crossings_are_odd(first, end - 1, p.y);
    } else if (level == 0) {
      odd ^= left_crossings_are_odd(first, p);
    } else {
      stack[on_stack++] = {level - 1, 2 * i};
      if (2 * i + 1 < size(level - 1)) stack[on_stack++] = {level - 1, 2 * i + 1};
    }
  }
  return odd;
}

/// For consecutive pieces that are all left of the beginning of the ray. A path crosses the line of the ray an odd
/// number of times if its ends are on different sides of it. Rings between the first and the last one are closed.
bool RingTree::left_crossings_are_odd(std::uint32_t first_leaf, std::uint32_t last_leaf, double y) const {
  const Leaf &first = leaves_[first_leaf], &last = leaves_[last_leaf];
  const auto above = [&](std::uint32_t vertex) { return points_[vertex].y > y; };
  bool odd = above(first.first) != above(last.last);
  if (first.ring != last.ring) odd ^= above(begin(first.ring)) != above(begin(last.ring));
  return odd;
}

bool RingTree::left_crossings_are_odd(std::uint32_t leaf, const Point& p) const {
  bool odd = false;
  for (std::uint32_t e = leaves_[leaf].first; e < leaves_[leaf].last; ++e) {
    const Point &a = points_[e], &b = points_[e + 1];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    odd ^= (b.y > a.y ? orientation(a, b, p) : orientation(b, a, p)) < 0;
  }
  return odd;
}

}  // namespace oblast::internal
