// `oblast check` and `oblast check --coverage`: all faults of features, and between them.
#pragma once

#include <string>

#include "oblast/check_input.h"

namespace oblast::app {

struct LayerCheckArguments {
  CheckInput input;
  bool coverage = false;
  std::string faults;   ///< a point layer to write; empty: none
  std::string picture;  ///< empty: none
  bool overwrite = false;
  int threads = 0;
  bool json = false;
  bool quiet = false;
};

/// Prints the findings. Returns an exit code.
int check_layer(const LayerCheckArguments& arguments);

}  // namespace oblast::app
