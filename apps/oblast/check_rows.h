// `oblast check --rows`: proves that the features of a file are rows that fit together (G8).
#pragma once

#include <oblast/options.h>

#include <string>

#include "io/layer.h"
#include "oblast/check_input.h"

namespace oblast::app {

/// Prints the finding. Returns an exit code.
int check_rows(const CheckInput& input, ContourConvention convention, bool quiet, bool json);

/// Reading repairs some faults, so a check cannot see them. This text names them; empty: none.
std::string mended(const io::ReadReport& report);

}  // namespace oblast::app
