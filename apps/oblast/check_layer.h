// `oblast check` and `oblast check --coverage`: all faults of features, and between them.
#pragma once

#include <string>

namespace oblast::app {

struct LayerCheckArguments {
  std::string file;
  bool coverage = false;
  std::string faults;  ///< a point layer to write; empty: none
  bool overwrite = false;
  int threads = 0;
  bool json = false;
};

/// Prints the findings. Returns an exit code.
int check_layer(const LayerCheckArguments& arguments);

}  // namespace oblast::app
