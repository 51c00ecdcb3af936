// What the grid counts on: at() does not decrease, and every value is at or after its line and not after its end.
#include "locate/lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "generators/random.h"

namespace oblast::internal::locate {
namespace {

void expect_laws(const PartedAxis& axis, std::vector<double> values) {
  std::sort(values.begin(), values.end());
  std::size_t before = 0;
  for (const double value : values) {
    const std::size_t column = axis.lines().at(value);
    ASSERT_GE(column, before) << value;
    ASSERT_LE(axis.line(column), value);
    ASSERT_LE(value, axis.end_of(column));
    ASSERT_LE(axis.first_by(value), column);
    ASSERT_GE(axis.last_by(value), column);
    before = column;
  }
  for (std::size_t i = 1; i < axis.count(); ++i) ASSERT_LT(axis.line(i - 1), axis.line(i));
}

TEST(Lines, holdTheirValues) {
  generators::Random random(3);
  for (int round = 0; round < 400; ++round) {
    // From columns as wide as the distance to 0 down to the narrowest that there are.
    const double offset = random.one_in(3) ? 0 : std::ldexp(random.in(-1, 1), random.between(-40, 40));
    const double extent = std::ldexp(1 + random.unit(), random.between(-40, 40));
    const double low = offset, high = offset + extent;
    const double margin = PartedAxis::margin_of(low, high);
    const double most = std::min(1000.0, PartedAxis::most_columns(high - low, margin));
    if (!(most >= 1)) continue;
    const std::size_t count =
        random.one_in(2) ? static_cast<std::size_t>(most) : 1 + static_cast<std::size_t>(random.unit() * (most - 1));
    const PartedAxis axis(low, high, margin, count);
    std::vector<double> values = {low, high};
    for (std::size_t i = 0; i < axis.count(); ++i) {
      for (double value : {axis.line(i), axis.line(i) + margin, axis.end_of(i)}) {
        value = std::clamp(value, low, high);
        for (const double v : {std::nextafter(value, -INFINITY), value, std::nextafter(value, INFINITY)})
          if (low <= v && v <= high) values.push_back(v);
      }
      values.push_back(std::clamp(random.in(low, high), low, high));
    }
    expect_laws(axis, values);

    // A column of it, parted again.
    const std::size_t column = static_cast<std::size_t>(random.unit() * static_cast<double>(count));
    const double from = axis.line(column), to = axis.end_of(column);
    const double finer = std::min(9.0, PartedAxis::most_columns(to - from, margin));
    if (finer < 1) continue;
    std::erase_if(values, [&](double v) { return axis.lines().at(v) != column; });
    expect_laws(PartedAxis(from, to, margin, static_cast<std::size_t>(finer)), values);
  }
}

TEST(Lines, oneColumnHoldsAll) {
  const PartedAxis axis(4, 4, PartedAxis::margin_of(4, 4), 1);
  EXPECT_EQ(axis.lines().at(4), 0u);
  EXPECT_EQ(axis.line(0), 4);
  EXPECT_EQ(axis.end_of(0), 4);
}

TEST(Lines, whatIsOutsideHasTheFirstColumnOrTheLast) {
  const PartedAxis axis(0, 1, PartedAxis::margin_of(0, 1), 10);
  EXPECT_EQ(axis.lines().at(-1e90), 0u);
  EXPECT_EQ(axis.lines().at(1e90), 9u);
}

}  // namespace
}  // namespace oblast::internal::locate
