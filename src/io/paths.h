// Expands the names on the command line (files, folders, standard input) to a list of files.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace oblast::io {

/// Replaces each folder by the vector files in it, sorted by the bytes of their names. `-` stays. Throws IoError for a
/// name that does not exist, and for a folder without vector files.
std::vector<std::string> expand_paths(std::span<const std::string> paths);

/// The contents of a file, or of standard input for `-`. Throws IoError.
std::string read_text(const std::string& path);

}  // namespace oblast::io
