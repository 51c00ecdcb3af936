// Writing a file with GDAL. Only for use inside src/io, because it has GDAL types.
#pragma once

#include <oblast/region_set.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/gdal_output_file.h"

namespace oblast::io {

/// Writes one feature per polygon. Its attribute `polygon` is its number: from `numbers`, or its position if `numbers`
/// is empty. Then reads the file back, and throws IoError if something is missing. `notes`, if any, gets a line if
/// coordinates were rounded.
void write_with_gdal(const GdalLayer& what, const RegionView& regions, std::span<const std::int32_t> numbers,
                     std::vector<std::string>* notes);

}  // namespace oblast::io
