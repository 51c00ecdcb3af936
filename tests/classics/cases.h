// Random operands inside and outside the domain of each classic.
#pragma once

#include <oblast/classics.h>
#include <oblast/region_set.h>

#include <string>
#include <vector>

#include "generators/random.h"

namespace oblast::tests {

using generators::Random;

/// How the coordinates of a case are spread.
enum class Spread {
  grid,    ///< small integers: everything coincides
  reals,   ///< doubles of [0, 1) at a random place and scale
  nearly,  ///< a grid moved by units in the last place: meetings that rounding may change
};

struct ClassicCase {
  RegionSet a;
  RegionSet b;
  Operation operation = Operation::intersection;
  Spread spread = Spread::grid;
};

/// A point of the plane under a spread; one scale and origin a case.
class Plane {
 public:
  Plane(Random& random, Spread spread, int size);
  /// A random point.
  Point point();
  /// An integer place of [0, size]^2 (times `fine` in the real spreads) as a point of this plane.
  Point at(int x, int y);
  int size() const { return size_; }
  Random& random() { return random_; }

 private:
  Random& random_;
  Spread spread_;
  int size_;
  double scale_ = 1, x0_ = 0, y0_ = 0;
};

Spread draw_spread(Random& random);

/// A case in the method's domain.
ClassicCase inside(ClassicMethod method, Random& random);

/// A case outside it, why, and what the error must name.
struct OutsideCase {
  ClassicCase operands;
  std::string why;
  enum class Names { vertex, contour, nothing } names;
};
OutsideCase outside(ClassicMethod method, Random& random);

/// The rule under which `overlay` reads an operand of the case as the method does.
Options engine_options(ClassicMethod method, const ClassicCase& c);

RegionSet one_contour(std::vector<Point> points);

/// A case for the fast paths of `overlay`: one operand is convex, the other anything: convex too, general polygons,
/// several that overlap or nest, or one that is a mess far from a small window.
ClassicCase window_case(Random& random);

/// The result of `overlay` by all stages of the pipeline: it requests statistics, so no fast path is taken.
RegionSet by_pipeline(const RegionView& a, const RegionView& b, Operation operation, Options options = {});

/// The same for a case: what the method must give.
RegionSet expected(ClassicMethod method, const ClassicCase& c);

}  // namespace oblast::tests
