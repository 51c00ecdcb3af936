// Results made wrong on purpose, in each way that somebody may get them wrong.
#pragma once

#include <oblast/region_set.h>

#include <span>

#include "generators/random.h"

namespace oblast::testing {

struct Mutation {
  const char* name;
  RegionSet (*make)(const RegionSet& regions, generators::Random& random);
};

/// Some of them leave some regions right. REQUIRES: regions that are not empty.
std::span<const Mutation> mutations();

}  // namespace oblast::testing
