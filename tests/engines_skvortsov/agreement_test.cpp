// The engine gives the same bytes as the default engine, for any options.
#include <gtest/gtest.h>
#include <oblast/overlay.h>

#include "generators/hostile.h"
#include "generators/trial.h"
#include "support/same_bits.h"
#include "verify/text_regions.h"

namespace oblast::testing {
namespace {

constexpr Operation operations[] = {Operation::intersection, Operation::unite, Operation::difference,
                                    Operation::symmetric_difference};

void expect_agreement(const generators::Operands& operands, Options options, const std::string& where) {
  for (const Operation operation : operations) {
    options.engine = Engine::leonov_nikitin;
    const RegionSet expected = overlay(operands.a, operands.b, operation, options);
    options.engine = Engine::skvortsov;
    const RegionSet found = overlay(operands.a, operands.b, operation, options);
    ASSERT_TRUE(same_bits(found, expected)) << where << " operation " << static_cast<int>(operation);
  }
}

TEST(Agreement, byHand) {
  const auto both = [](const char* a, const char* b) {
    for (const auto contours : {ContourConvention::ogc, ContourConvention::leonov_nikitin}) {
      Options options;
      options.contours = contours;
      expect_agreement({verify::regions_of(a), verify::regions_of(b)}, options, a);
    }
  };
  both("", "");
  both("0 0, 4 0, 4 4, 0 4", "");
  both("0 0, 4 0, 4 4, 0 4", "0 0, 4 0, 4 4, 0 4");                       // nothing is left of the differences
  both("0 0, 4 0, 4 4, 0 4", "4 4, 8 4, 8 8, 4 8");                       // touch at a corner
  both("0 0, 9 0, 9 9, 0 9", "0 0, 4 2, 2 4; 9 9, 5 7, 7 5");             // pinched holes
  both("0 0, 9 0, 9 9, 0 9", "2 4.5, 4.5 2, 7 4.5, 4.5 7");               // a hole that meets nothing
  both("0 0, 9 0, 9 9, 0 9", "1 1, 5 1, 5 5, 1 5 | 5 5, 8 5, 8 8, 5 8");  // two holes that touch
  both("0 0, 6 0, 6 6, 0 6 | 3 0, 9 0, 9 6, 3 6", "2 -1, 7 -1, 7 7, 2 7");
}

class Agreement : public ::testing::TestWithParam<generators::HostileGenerator> {};

TEST_P(Agreement, onHostileInput) {
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    const generators::Request request = generators::draw_request(seed);
    Options options;
    options.fill_a = request.fill_a;
    options.fill_b = request.fill_b;
    options.contours = request.contours;
    options.collinear = request.collinear;
    expect_agreement(GetParam().make(seed, 8 + static_cast<int>(seed % 50)), options, "seed " + std::to_string(seed));
    if (HasFatalFailure()) return;
  }
}

std::string name_of(const ::testing::TestParamInfo<generators::HostileGenerator>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Generators, Agreement,
                         ::testing::ValuesIn(generators::hostile_generators().begin(),
                                             generators::hostile_generators().end()),
                         name_of);

}  // namespace
}  // namespace oblast::testing
