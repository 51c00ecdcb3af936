// Helpers of the tests of reading and writing: a temporary folder, hand-made files, unusual polygons.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "io/read.h"
#include "io/write.h"

namespace oblast::io {

/// A folder that exists as long as the test runs.
class FolderTest : public ::testing::Test {
 protected:
  FolderTest();
  ~FolderTest() override;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  /// Writes a text file and returns its path.
  std::string file(const std::string& name, const std::string& text) const;
  std::string contents(const std::string& name) const;
  /// Names of all entries, hidden ones too, sorted.
  std::vector<std::string> names() const;
  bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
  /// Replaces bytes of a file.
  void patch(const std::string& name, std::size_t at, const std::string& bytes) const;
  void truncate(const std::string& name, std::size_t bytes) const;

  std::filesystem::path folder_;
};

Layer read_file(const std::string& path, const ReadOptions& options = {});

/// The message of the IoError that reading throws; empty if it throws none.
std::string read_error(const std::string& path, const ReadOptions& options = {});
std::string write_error(const std::string& path, const RegionView& regions, const WriteOptions& options = {});

/// Polygons with a given outer contour, holes, and any number of vertices.
RegionSet one_triangle();
RegionSet square_with_hole();
/// `count` small polygons with coordinates that use all bits, in degrees of longitude and latitude.
RegionSet scattered(std::size_t count, unsigned seed);

/// The same arrays and the same bits, the sign of zero included.
::testing::AssertionResult same_bits(const RegionSet& a, const RegionSet& b);

bool mentions(const std::string& text, const std::vector<std::string>& words);

/// A coordinate system as WKT, by way of a GeoJSON file: EPSG:4326, EPSG:3035, ...
std::string crs_wkt(const std::string& folder, int epsg);

}  // namespace oblast::io
