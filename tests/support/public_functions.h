// Every public function of the library on the same operands, for tests of properties that all must have.
#pragma once

#include <oblast/options.h>
#include <oblast/region_set.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace oblast::testing {

/// All bits of what a function returned.
using Bits = std::vector<std::uint64_t>;

struct PublicFunction {
  std::string name;
  std::function<Bits(const CallOptions&)> call;
};

/// Of any operands: overlays by each engine, unions, hulls, layers, triangulations, areas; and ClipWindow and the
/// classics on what is in their domain: `convex` with itself moved, and `a` clipped to it. They are looked at when they
/// are called. REQUIRES: `convex` is one convex contour.
std::vector<PublicFunction> public_functions(const RegionSet& a, const RegionSet& b, const RegionSet& convex);

}  // namespace oblast::testing
