// Files on the disk, or by a virtual path of GDAL such as /vsizip/fires.zip/june.shp.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace oblast::io {

/// The contents of a file, or of standard input for `-`. Throws IoError.
std::string read_text(const std::string& path);

/// True for a file or a folder.
bool path_exists(const std::string& path);
bool is_folder(const std::string& path);
/// In bytes; 0 if there is no such file.
std::uint64_t size_of_file(const std::string& path);

/// "a", "a and b", "a, b, c and 4 more".
std::string name_list(std::span<const std::string> names);

}  // namespace oblast::io
