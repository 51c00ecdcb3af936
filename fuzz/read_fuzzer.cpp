// Readers on mutated files: whatever the bytes, reading ends with a layer or an IoError, and a layer that was read is
// one that an overlay takes.
//
//   F bytes...             the file itself; F below 128 chooses the format
//   F P C (OOO V)...       a file that oblast wrote, changed: of the files that belong to it the P-th, C bytes cut off
//                          its end, and at each offset O (three bytes) the value V
#include <fuzzer/FuzzedDataProvider.h>
#include <oblast/overlay.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "io/read.h"
#include "io/write.h"
#include "scratch_folder.h"

namespace {

using namespace oblast;

struct NamedFile {
  std::string extension;
  std::string bytes;
};
using FileSet = std::vector<NamedFile>;  // a shapefile is several files; the first one is the one to read

std::string path_of(const std::string& extension) { return (fuzz::scratch_folder() / ("input" + extension)).string(); }

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Two polygons, one with a hole, as oblast writes them.
FileSet written(const std::string& extension) {
  const RegionSet regions{
      {{0, 0}, {4, 0.1}, {4, 4}, {0, 4}, {1, 1}, {1, 2}, {2, 2}, {5, 0}, {6, 1e-3}, {1.0 / 3 + 5, 70}},
      {4, 7, 10},
      {2, 3}};
  io::WriteOptions options;
  options.crs_wkt =
      R"(GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],PRIMEM["Greenwich",0],)"
      R"(UNIT["degree",0.0174532925199433],AUTHORITY["EPSG","4326"]])";
  io::write(path_of(extension), regions, options);
  FileSet files{{extension, bytes_of(path_of(extension))}};
  for (const auto& entry : std::filesystem::directory_iterator(fuzz::scratch_folder())) {
    const std::string other = entry.path().extension().string();
    if (other != extension) files.push_back({other, bytes_of(entry.path())});
  }
  std::sort(files.begin() + 1, files.end(), [](const auto& a, const auto& b) { return a.extension < b.extension; });
  fuzz::empty_scratch_folder();
  return files;
}

FileSet changed(FuzzedDataProvider& bytes, std::uint8_t format) {
  static const std::array originals = {written(".shp"), written(".fgb"), written(".gpkg"), written(".geojson")};
  FileSet files = originals[format % originals.size()];
  std::string& content = files[bytes.ConsumeIntegral<std::uint8_t>() % files.size()].bytes;
  const std::uint8_t cut = bytes.ConsumeIntegral<std::uint8_t>();
  content.resize(content.size() - std::min<std::size_t>(cut, content.size()));
  while (bytes.remaining_bytes() >= 4 && !content.empty()) {
    const auto offset = bytes.ConsumeIntegralInRange<std::uint32_t>(0, 0xffffff);
    content[offset % content.size()] = bytes.ConsumeIntegral<char>();
  }
  return files;
}

FileSet files_from(const std::uint8_t* data, std::size_t size) {
  constexpr const char* extensions[] = {".geojson", ".topojson", ".fgb", ".gpkg", ".shp", ".wkt"};
  FuzzedDataProvider bytes(data + 1, size - 1);
  if (data[0] >= 128) return changed(bytes, data[0]);
  return {{extensions[data[0] % std::size(extensions)], bytes.ConsumeRemainingBytesAsString()}};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t most_vertices = 2000;  // so that one input takes milliseconds
  if (size == 0) return 0;
  const FileSet files = files_from(data, size);
  for (const NamedFile& file : files) std::ofstream(path_of(file.extension), std::ios::binary) << file.bytes;
  try {
    const std::string paths[] = {path_of(files[0].extension)};
    const io::Layer layer = io::read(paths, {.threads = 1});
    if (layer.regions.points.size() <= most_vertices) unite(layer.regions);
  } catch (const io::IoError&) {
  }
  fuzz::empty_scratch_folder();
  return 0;
}
