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

  /// Two work without options of a call, so no option can stop them.
  bool takes_options() const { return name != "signed_area" && name != "RegionBuilder"; }
  /// Others return numbers or a report: they may do with the memory that a small call brings with it, or with none.
  bool returns_much() const {
    return takes_options() && name != "area" && name != "bounds" && !name.starts_with("check");
  }
};

/// Of any operands: overlays by each engine and into a result, unions, checks, hulls, layers, triangulations, areas and
/// bounds, a Locator, a RegionBuilder, WKT and WKB; and ClipWindow and the classics on what is in their domain:
/// `convex` with itself moved, and `a` clipped to it. The operands are looked at when the functions are called; a few
/// are given what is made of them before. REQUIRES: `convex` is one convex contour.
std::vector<PublicFunction> public_functions(const RegionSet& a, const RegionSet& b, const RegionSet& convex);

}  // namespace oblast::testing
