// `oblast check --regions`: proves that a file is one region set, or that it is the right result.
#pragma once

#include <oblast/options.h>

#include <string>

#include "oblast/check_against.h"
#include "oblast/check_input.h"

namespace oblast::app {

struct RegionCheckArguments {
  CheckInput input;
  bool canonical = false;
  ContourConvention convention = ContourConvention::ogc;
  AgainstArguments against;
  bool quiet = false;
};

/// Prints the first fault, or that there is none. Returns an exit code.
int check_regions(const RegionCheckArguments& arguments, bool json);

}  // namespace oblast::app
