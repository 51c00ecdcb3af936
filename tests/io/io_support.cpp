// Helpers of the tests of reading and writing; see io_support.h.
#include "io_support.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>

namespace oblast::io {

namespace fs = std::filesystem;

FolderTest::FolderTest() {
  std::string pattern = (fs::temp_directory_path() / "oblast-io-XXXXXX").string();
  if (!::mkdtemp(pattern.data())) throw std::runtime_error("no temporary folder");
  folder_ = pattern;
}

FolderTest::~FolderTest() {
  std::error_code error;
  fs::remove_all(folder_, error);
}

std::string FolderTest::file(const std::string& name, const std::string& text) const {
  fs::create_directories((folder_ / name).parent_path());
  std::ofstream(folder_ / name, std::ios::binary) << text;
  return path(name);
}

std::string FolderTest::contents(const std::string& name) const {
  std::ifstream stream(folder_ / name, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::vector<std::string> FolderTest::names() const {
  std::vector<std::string> result;
  for (const auto& entry : fs::directory_iterator(folder_)) result.push_back(entry.path().filename().string());
  std::sort(result.begin(), result.end());
  return result;
}

void FolderTest::patch(const std::string& name, std::size_t at, const std::string& bytes) const {
  std::fstream stream(folder_ / name, std::ios::binary | std::ios::in | std::ios::out);
  stream.seekp(static_cast<std::streamoff>(at));
  stream << bytes;
}

void FolderTest::truncate(const std::string& name, std::size_t bytes) const { fs::resize_file(folder_ / name, bytes); }

Layer read_file(const std::string& path, const ReadOptions& options) {
  const std::string paths[] = {path};
  return read(paths, options);
}

std::string read_error(const std::string& path, const ReadOptions& options) {
  try {
    read_file(path, options);
  } catch (const IoError& error) {
    return error.what();
  }
  return {};
}

std::string write_error(const std::string& path, const RegionView& regions, const WriteOptions& options) {
  try {
    write(path, regions, options);
  } catch (const IoError& error) {
    return error.what();
  }
  return {};
}

RegionSet one_triangle() { return {{{0, 0}, {4, 0}, {0, 3}}, {3}, {1}}; }

RegionSet square_with_hole() {
  return {
      {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {2, 2}, {2, 6}, {6, 6}, {6, 2}, {10, 0}, {12, 0}, {12, 1}}, {4, 8, 11}, {2, 3}};
}

RegionSet scattered(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> longitude(30, 180), latitude(50, 72), size(1e-9, 0.1);
  RegionSet set;
  for (std::size_t p = 0; p < count; ++p) {
    const double x = longitude(random), y = latitude(random), r = size(random);
    const std::size_t vertices = 3 + random() % 8;
    for (std::size_t i = 0; i < vertices; ++i) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(vertices);
      set.points.push_back({x + r * std::cos(angle), y + r * std::sin(angle)});
    }
    set.contour_ends.push_back(static_cast<std::uint32_t>(set.points.size()));
    set.polygon_ends.push_back(static_cast<std::uint32_t>(p + 1));
  }
  return set;
}

::testing::AssertionResult same_bits(const RegionSet& a, const RegionSet& b) {
  if (a.points.size() != b.points.size()) {
    return ::testing::AssertionFailure() << a.points.size() << " vertices and " << b.points.size();
  }
  if (a.contour_ends != b.contour_ends) return ::testing::AssertionFailure() << "other contours";
  if (a.polygon_ends != b.polygon_ends) return ::testing::AssertionFailure() << "other polygons";
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    if (std::memcmp(&a.points[i], &b.points[i], sizeof(Point)) != 0) {
      return ::testing::AssertionFailure() << fmt::format("vertex {}: {} {} and {} {}", i, a.points[i].x, a.points[i].y,
                                                          b.points[i].x, b.points[i].y);
    }
  }
  return ::testing::AssertionSuccess();
}

bool mentions(const std::string& text, const std::vector<std::string>& words) {
  return std::all_of(words.begin(), words.end(),
                     [&](const std::string& word) { return text.find(word) != std::string::npos; });
}

std::string crs_wkt(const std::string& folder, int epsg) {
  const std::string name = fmt::format("{}/.crs-{}.geojson", folder, epsg);
  std::ofstream(name) << fmt::format(
      R"({{"type":"FeatureCollection","crs":{{"type":"name","properties":{{"name":"urn:ogc:def:crs:EPSG::{}"}}}},)"
      R"("features":[{{"type":"Feature","properties":{{}},"geometry":)"
      R"({{"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]]]}}}}]}})",
      epsg);
  const std::string wkt = read_file(name).crs_wkt;
  fs::remove(name);
  return wkt;
}

}  // namespace oblast::io
