// The circumcentre of three points: the exact rational point, each coordinate rounded to nearest.
#pragma once

#include <oblast/point.h>

namespace oblast::internal::exact {

/// The point that is as far from a as from b and from c, each coordinate the nearest double to the exact value, ties to
/// even; a magnitude below the domain becomes 0 or domain_smallest, whichever is nearer. As a function of the exact
/// point it has the same bits for any three points of one circle. REQUIRES: the three are not collinear, and the
/// circumcentre is within the domain's largest magnitude.
Point circumcentre(const Point& a, const Point& b, const Point& c);

}  // namespace oblast::internal::exact
