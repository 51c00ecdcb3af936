#include "exact/orientation.h"

#include "exact/expansion.h"

namespace oblast::internal::exact {

int orientation_exact(const Point& a, const Point& b, const Point& c) {
  const Expansion<2> acx = difference(a.x, c.x), acy = difference(a.y, c.y);
  const Expansion<2> bcx = difference(b.x, c.x), bcy = difference(b.y, c.y);
  return (acx * bcy - acy * bcx).sign();
}

}  // namespace oblast::internal::exact
