// Writing a file with GDAL.
#pragma once

#include <oblast/region_set.h>

#include <cstdint>
#include <span>
#include <string>

namespace oblast::io {

/// Writes one feature a polygon with its number as the attribute `polygon` (from `numbers`, or where that
/// is empty its place), reads the file back to
/// see that all of it is there, and throws IoError when not. `driver` is GDAL's name of the format;
/// `name` stands for the file in messages.
void write_with_gdal(const std::string& path, const char* driver, const RegionView& regions, const std::string& crs_wkt,
                     const std::string& name, std::span<const std::int32_t> numbers = {});

}  // namespace oblast::io
