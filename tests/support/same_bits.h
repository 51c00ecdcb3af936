// Regions compared bit by bit: -0.0 is not 0.0 here.
#pragma once

#include <oblast/region_set.h>

#include <cstring>

namespace oblast::testing {

inline bool same_bits(const RegionSet& r, const RegionSet& s) {
  // An empty vector may point nowhere, which memcmp does not take, not even for no bytes.
  return r == s && (r.empty() || std::memcmp(r.points.data(), s.points.data(), r.points.size() * sizeof(Point)) == 0);
}

}  // namespace oblast::testing
