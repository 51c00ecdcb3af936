// `oblast check --rows`: proves that the features of a file are rows that fit together (G8).
#pragma once

#include <oblast/options.h>

#include <string>

#include "io/layer.h"

namespace oblast::app {

/// Prints the finding. Returns an exit code.
int check_rows(const std::string& file, ContourConvention convention, bool json);

/// Reading repairs some faults, so a check cannot see them. This text names them; empty: none.
std::string mended(const io::ReadReport& report);

}  // namespace oblast::app
