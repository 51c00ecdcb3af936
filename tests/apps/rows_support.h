// Layers with attributes for tests of the program, and what a file of rows has, as text.
#pragma once

#include <string>
#include <vector>

#include "apps/program_run.h"

namespace oblast::test {

/// A GeoJSON feature: the square [x, x + w] x [0, w] with these properties ("\"name\": 3"). Without width it has no
/// geometry.
std::string square(double x, double w, const std::string& properties);
/// Writes features as a GeoJSON file in metres (EPSG:3035).
void write_layer(const std::filesystem::path& path, const std::vector<std::string>& features);

struct RowsOfFile {
  std::string columns;            ///< "name: text, people: 64-bit integers"
  std::vector<std::string> rows;  ///< "name=Ä people=null area=4", in the order of the file
};
RowsOfFile rows_of(const std::string& path);

/// The area of all rows of a file.
double area_of(const std::string& path);

using Lines = std::vector<std::string>;

}  // namespace oblast::test
