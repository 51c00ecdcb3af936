// From what a person names (files, folders, standard input) to the list of files to read.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace oblast::io {

/// Folders are replaced by the vector files in them, by name (bytes compared); `-` stays. Throws
/// IoError for what does not exist and for a folder without vector files.
std::vector<std::string> expand_paths(std::span<const std::string> paths);

/// The whole of a file, or of standard input for `-`. Throws IoError.
std::string read_text(const std::string& path);

}  // namespace oblast::io
