// Whether a coordinate is an exact rational number, correctly rounded.
#pragma once

#include <gtest/gtest.h>
#include <oblast/domain.h>

#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>

namespace oblast::testing {

/// The nearest number of the domain; of two equally near the even one; 0 when it is as near as the smallest.
inline void expect_nearest(double rounded, const boost::multiprecision::cpp_rational& value) {
  using Rational = boost::multiprecision::cpp_rational;
  ASSERT_TRUE(in_domain(rounded));
  ASSERT_FALSE(rounded == 0 && std::signbit(rounded));
  const auto neighbour = [&](double towards) {
    const double next = std::nextafter(rounded, towards);
    if (in_domain(next)) return next;
    return rounded == 0 ? std::copysign(domain_smallest, towards) : 0.0;
  };
  const Rational distance = abs(Rational(rounded) - value);
  for (const double other : {neighbour(INFINITY), neighbour(-INFINITY)}) {
    const Rational other_distance = abs(Rational(other) - value);
    ASSERT_LE(distance, other_distance) << rounded << " instead of " << other;
    if (distance != other_distance) continue;
    const auto odd = [](double x) { return (std::bit_cast<std::uint64_t>(x) & 1) != 0; };
    ASSERT_FALSE(odd(rounded) || other == 0) << rounded << " instead of " << other;
  }
}

}  // namespace oblast::testing
