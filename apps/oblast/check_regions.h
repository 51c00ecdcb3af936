// `oblast check --regions`: proves that a file is one region set, or that it is the right result.
#pragma once

#include <oblast/options.h>

#include <string>

#include "oblast/check_against.h"

namespace oblast::app {

struct RegionCheckArguments {
  std::string file;
  bool canonical = false;
  ContourConvention convention = ContourConvention::ogc;
  AgainstArguments against;
};

/// Prints the first fault, or that there is none. Returns an exit code.
int check_regions(const RegionCheckArguments& arguments, bool json);

}  // namespace oblast::app
