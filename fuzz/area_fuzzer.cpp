// The signed area: that of exact rationals, up to the rounding of its terms.
#include <oblast/overlay.h>

#include <cmath>
#include <string>

#include "bytes_to_operands.h"
#include "verify/rational.h"
#include "verify/slabs.h"

namespace {

using namespace oblast;

// What the terms are made of: two products each. With u = 2^-53 a product of differences is off by 3 u of itself, their
// difference by one u more, and the compensated sum by about 2 u of all terms: below 8 u of all products.
double products(const RegionView& regions) {
  double sum = 0;
  for (std::size_t c = 0; c < regions.contour_count(); ++c) {
    const auto ring = regions.contour(c);
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      const Point &o = ring[0], &p = ring[i], &q = ring[i + 1];
      sum += std::abs((p.x - o.x) * (q.y - o.y)) + std::abs((q.x - o.x) * (p.y - o.y));
    }
  }
  return sum;
}

void check(const RegionView& regions, const fuzz::Input& input) {
  const verify::Rational error = abs(verify::Rational(signed_area(regions)) - verify::exact_signed_area(regions));
  if (error > verify::Rational(products(regions) * 0x1p-50))
    fuzz::report({generators::Broken::area, Operation::unite, "off by " + error.str()}, input);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::Input input = fuzz::input_from(data, size);
  check(input.operands.a, input);
  check(unite(input.operands.a), input);
  return 0;
}
