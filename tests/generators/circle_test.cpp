// Sine and cosine of the generators.
#include "generators/circle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "generators/random.h"

namespace oblast::generators {
namespace {

TEST(Circle, isWithinAUnitInTheLastPlaceOfTheLibrarys) {
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const double angle = std::ldexp(random.in(-1, 1), random.between(-20, 12));
    for (const auto& [mine, library] :
         {std::pair(sine(angle), std::sin(angle)), std::pair(cosine(angle), std::cos(angle))}) {
      // The error of the C library is at most one unit in the last place.
      EXPECT_LE(std::fabs(mine - library), std::nextafter(std::fabs(library), 2) - std::fabs(library)) << angle;
    }
  }
}

TEST(Circle, hasTheseBits) {
  EXPECT_EQ(sine(0), 0);
  EXPECT_EQ(cosine(0), 1);
  EXPECT_EQ(sine(1), 0x1.aed548f090ceep-1);
  EXPECT_EQ(cosine(1), 0x1.14a280fb5068cp-1);
  EXPECT_EQ(cosine(0x1.921fb54442d18p+0), 0x1.1a62633145c07p-54);  // of the double nearest to a quarter turn
  EXPECT_EQ(sine(-5), 0x1.eaf81f5e09933p-1);
}

}  // namespace
}  // namespace oblast::generators
