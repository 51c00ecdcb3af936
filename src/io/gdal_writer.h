// Writing a file with GDAL.
#pragma once

#include <oblast/region_set.h>

#include <cstdint>
#include <span>
#include <string>

namespace oblast::io {

/// Writes one feature per polygon. Its attribute `polygon` is its number: from `numbers`, or its position if `numbers`
/// is empty. Then reads the file back, and throws IoError if something is missing. `driver` is GDAL's name of the
/// format; messages call the file `name`.
void write_with_gdal(const std::string& path, const char* driver, const RegionView& regions, const std::string& crs_wkt,
                     const std::string& name, std::span<const std::int32_t> numbers = {});

}  // namespace oblast::io
