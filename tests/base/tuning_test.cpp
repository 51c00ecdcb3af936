// The settings of the constants: the values that `random` draws are in their range and cover all of it.
#include "base/tuning.h"

#include <gtest/gtest.h>

#include <bit>
#include <set>
#include <string>

namespace oblast::internal::tuning {
namespace {

TEST(Tuning, drawsLieBetweenTheTwo) {
  for (int i = 0; i < 2000; ++i) {
    const std::string name = "constant " + std::to_string(i);
    const auto low = static_cast<std::uint64_t>(1 + i % 40), high = low + static_cast<std::uint64_t>(i) * i / 7;
    const std::uint64_t value = drawn(name, low, high);
    ASSERT_GE(value, low) << name;
    ASSERT_LE(value, high) << name;
    ASSERT_EQ(value, drawn(name, low, high)) << "another one when drawn again";
  }
}

TEST(Tuning, drawsComeToEveryValue) {
  std::set<std::uint64_t> values;
  std::size_t below_16 = 0;
  for (int i = 0; i < 2000; ++i) {
    const std::string name = "constant " + std::to_string(i);
    values.insert(drawn(name, 3, 9));
    below_16 += drawn(name, 1, 1 << 16) < 16;
  }
  EXPECT_EQ(values, (std::set<std::uint64_t>{3, 4, 5, 6, 7, 8, 9}));
  // Of 17 doublings four end below 16.
  EXPECT_GT(below_16, 300U);
  EXPECT_LT(below_16, 700U);
}

TEST(Tuning, settingsAreWhatTheyAreCalled) {
  constexpr int chosen = choose("chosen", 1000, 8), power = choose_power_of_two("power", 4096, 2);
  constexpr double fraction = choose("fraction", 0.5, 0.25);
  if (setting == Setting::usual) {
    EXPECT_EQ(chosen, 1000);
    EXPECT_EQ(power, 4096);
    EXPECT_EQ(fraction, 0.5);
  } else if (setting == Setting::tiny) {
    EXPECT_EQ(chosen, 8);
    EXPECT_EQ(power, 2);
    EXPECT_EQ(fraction, 0.25);
  } else {
    EXPECT_TRUE(8 <= chosen && chosen <= 1000) << chosen;
    EXPECT_TRUE(2 <= power && power <= 4096 && std::has_single_bit(static_cast<unsigned>(power))) << power;
    EXPECT_TRUE(0.25 <= fraction && fraction <= 0.5) << fraction;
  }
}

}  // namespace
}  // namespace oblast::internal::tuning
