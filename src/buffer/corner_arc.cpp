#include "buffer/corner_arc.h"

#include <oblast/domain.h>

#include <algorithm>
#include <cmath>

namespace oblast::internal::buffering {
namespace {

double in_domain_or_zero(double x) { return std::fabs(x) < domain_smallest ? 0 : x; }

/// The quarter turn counter-clockwise.
Point left_of(const Point& u) { return {-u.y, u.x}; }

/// The unit vector in the middle from u to w, counter-clockwise, also if they are opposite.
Point middle(const Point& u, const Point& w) {
  // The longer one of the sum and the chord is the exact one.
  const Point sum{u.x + w.x, u.y + w.y}, chord{w.x - u.x, w.y - u.y};
  const Point m = dot(u, w) >= 0 ? sum : Point{chord.y, -chord.x};
  const double length = std::sqrt(dot(m, m));
  return {m.x / length, m.y / length};
}

class Arc {
 public:
  Arc(const ZoneShape& shape, const CornerNormals& corner, Array<Point>& outline)
      : shape_(shape), corner_(corner), outline_(outline) {}

  void add(const Point& direction, double factor = 1) {
    outline_.push_back(moved(corner_.at, direction, factor * corner_.distance));
  }
  void add_from() { add(corner_.from); }
  void add_to() { add(corner_.to); }

  /// Where the tangents at two directions meet, but not further away than the reach. False if that is nearer.
  bool add_tangents(const Point& u, const Point& w) {
    const double cosine_2 = (1 + dot(u, w)) / 2;  // of half the angle, squared
    const double factor = 1 / (2 * cosine_2);     // |u + w| = 2 cos
    const double most = shape_.reach / (2 * std::sqrt(cosine_2));
    const bool is_meeting = shape_.mode != BufferMode::nearest || factor <= most;
    add({u.x + w.x, u.y + w.y}, is_meeting ? factor : most);
    return is_meeting;
  }

  void add_round() {
    const Directions& directions = shape_.directions;
    const Directions::Range range = directions.between(corner_.from, corner_.to);
    if (shape_.mode == BufferMode::inside) {
      add_from();
      for (std::size_t k = 0; k < range.count; ++k) add(directions[range.first + k]);
      add_to();
      return;
    }
    if (range.count == 0 && dot(corner_.from, corner_.to) >= shape_.straight_cosine) {
      add_from(), add_to();
      return;
    }
    const std::size_t begin = outline_.size();
    add_from();
    Point before = corner_.from;
    bool on_side = true;
    for (std::size_t k = 0; k <= range.count; ++k) {
      const Point next = k < range.count ? directions[range.first + k] : corner_.to;
      on_side = add_tangents(before, next);
      // The first vertex is on the tangent at the first normal: on the side itself.
      if (k == 0 && on_side) outline_.erase(outline_.begin() + static_cast<std::ptrdiff_t>(begin));
      before = next;
    }
    if (!on_side) add_to();
  }

  void add_mitre() {
    const Point from = corner_.from, to = corner_.to;
    const double cosine_2 = std::max(0.0, (1 + dot(from, to)) / 2), limit = shape_.mitre_limit;
    if (limit * limit * cosine_2 >= 1) return add({from.x + to.x, from.y + to.y}, 1 / (2 * cosine_2));
    // The tip is cut off across the middle, at the limit.
    const Point m = middle(from, to), along = left_of(m);
    const double cosine = std::sqrt(cosine_2), sine = std::sqrt(1 - cosine_2), half = (1 - limit * cosine) / sine;
    add({limit * m.x - half * along.x, limit * m.y - half * along.y});
    add({limit * m.x + half * along.x, limit * m.y + half * along.y});
  }

  void add_square() {
    const Point forward = middle(corner_.from, corner_.to);
    add({corner_.from.x + forward.x, corner_.from.y + forward.y});
    add({corner_.to.x + forward.x, corner_.to.y + forward.y});
  }

 private:
  const ZoneShape& shape_;
  const CornerNormals& corner_;
  Array<Point>& outline_;
};

}  // namespace

Point moved(const Point& from, const Point& by, double factor) {
  return {in_domain_or_zero(from.x + by.x * factor), in_domain_or_zero(from.y + by.y * factor)};
}

void append_join(const ZoneShape& shape, const CornerNormals& corner, Array<Point>& outline) {
  Arc arc(shape, corner, outline);
  switch (shape.join) {
    case Join::round:
      return arc.add_round();
    case Join::mitre:
      return arc.add_mitre();
    default:
      arc.add_from(), arc.add_to();
  }
}

void append_cap(const ZoneShape& shape, const CornerNormals& corner, Array<Point>& outline) {
  Arc arc(shape, corner, outline);
  if (shape.cap == Cap::round)
    arc.add_round();
  else
    arc.add_square();
}

void append_disc(const ZoneShape& shape, const Point& at, Array<Point>& outline) {
  if (shape.cap == Cap::flat) return;
  const CornerNormals corner{at, {}, {}, shape.distance_at(std::max(std::fabs(at.x), std::fabs(at.y)))};
  Arc arc(shape, corner, outline);
  if (shape.cap == Cap::square) {
    for (const Point& direction : {Point{-1, -1}, Point{1, -1}, Point{1, 1}, Point{-1, 1}}) arc.add(direction);
    return;
  }
  const Directions& directions = shape.directions;
  for (std::size_t k = 0; k < directions.count(); ++k) {
    if (shape.mode == BufferMode::inside)
      arc.add(directions[k]);
    else
      arc.add_tangents(directions[k], directions[k + 1]);
  }
}

}  // namespace oblast::internal::buffering
