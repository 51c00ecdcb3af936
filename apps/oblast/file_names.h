// The names of files in columns of results.
#pragma once

#include <string>
#include <vector>

#include "io/rows.h"

namespace oblast::app {

/// By layer and file: the name without folder and extension; the whole path if two files share that name.
std::vector<std::vector<std::string>> file_names(const std::vector<io::Rows>& layers);

}  // namespace oblast::app
