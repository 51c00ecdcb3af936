// The exact predicates of the checker: the side of a line, whether edges meet, and the order of directions.
#pragma once

#include <oblast/point.h>

namespace oblast::verify {

/// +1 if `c` lies to the left of the directed line a -> b, -1 to its right, 0 on it. Exact for
/// coordinates in the domain.
int side_of_line(const Point& a, const Point& b, const Point& c);

/// True if the closed segments ab and cd have a point in common that is not an end point of both,
/// or if they share more than one point. Exact.
bool meet_badly(const Point& a, const Point& b, const Point& c, const Point& d);

/// The order of edges along a sweep line, from below to above: whether edge e stands below edge f where both begin to
/// exist. False both ways if the newer one's left end lies on the other, or they leave one left end in the same
/// direction. Exact. REQUIRES: the left ends are lexicographically smaller than the right ends.
bool stands_below(const Point& e_left, const Point& e_right, const Point& f_left, const Point& f_right);

/// True if the directions u -> a and u -> b are the same (parallel and not opposite). Exact.
/// REQUIRES: a != u, b != u.
bool same_direction(const Point& u, const Point& a, const Point& b);

/// Orders rays that leave `u` by their angle in (-pi, pi], counter-clockwise from just after the negative
/// x axis. Exact. REQUIRES: a != u, b != u.
bool angle_less(const Point& u, const Point& a, const Point& b);

}  // namespace oblast::verify
