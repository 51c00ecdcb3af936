// `generate fires`: satellite passes over fires in Russia, as in the 2013 paper.
#pragma once

#include <oblast/region_set.h>

#include <cstdint>
#include <string>
#include <vector>

namespace oblast::app {

/// The months of the paper's Table 1 (without August), with its figures: the input of the union.
struct FireMonth {
  int month = 0;
  int days = 0;
  int files = 0;
  int contours = 0;
  int vertices = 0;  ///< of all contours, without closing points
};
inline constexpr FireMonth fire_months[] = {
    {4, 30, 470, 20634, 102389}, {5, 31, 1231, 69560, 405416}, {6, 30, 1322, 62292, 472804},
    {7, 31, 397, 16193, 64772},  {9, 30, 268, 13298, 53192},   {10, 31, 218, 8938, 35752},
};

/// One satellite pass, which becomes one file. Every contour is a polygon. Contours of one pass do not overlap.
struct FirePass {
  std::string name;  ///< "fires-2011-04-03-0712"
  RegionSet contours;
};

struct FiresOptions {
  std::uint64_t seed = 1;
  double scale = 1;         ///< factor for the numbers of files, contours and vertices; 1 gives exactly Table 1
  std::vector<int> months;  ///< empty: all six
};

/// The passes in order of time. The same seed and scale give the same bytes on every machine. A month is the same
/// whether it is generated alone or with others. Cost: about a second at scale 1.
std::vector<FirePass> generate_fires(const FiresOptions& options);

}  // namespace oblast::app
