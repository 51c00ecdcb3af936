// `generate fires`: satellite passes over fires in Russia, as in the paper of 2013 (include/oblast/layers.h).
#pragma once

#include <oblast/region_set.h>

#include <cstdint>
#include <string>
#include <vector>

namespace oblast::app {

/// The months of the paper's Table 1 (no August), as printed there: input of the union.
struct FireMonth {
  int month = 0;
  int days = 0;
  int files = 0;
  int contours = 0;
  int vertices = 0;  ///< of all contours, closing points not counted
};
inline constexpr FireMonth fire_months[] = {
    {4, 30, 470, 20634, 102389}, {5, 31, 1231, 69560, 405416}, {6, 30, 1322, 62292, 472804},
    {7, 31, 397, 16193, 64772},  {9, 30, 268, 13298, 53192},   {10, 31, 218, 8938, 35752},
};

/// One pass: one file. Every contour is a polygon of its own; contours of one pass do not overlap.
struct FirePass {
  std::string name;  ///< "fires-2011-04-03-0712"
  RegionSet contours;
};

struct FiresOptions {
  std::uint64_t seed = 1;
  double scale = 1;         ///< of files, contours and vertices; 1 gives Table 1 to the unit
  std::vector<int> months;  ///< empty: all six
};

/// The passes in order of time: the same bytes on every machine for the same seed and scale, and a
/// month is the same whether made alone or with others. Cost: about a second at scale 1.
std::vector<FirePass> generate_fires(const FiresOptions& options);

}  // namespace oblast::app
