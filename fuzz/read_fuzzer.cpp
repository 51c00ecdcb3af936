// Readers on mutated files: for any bytes, reading ends with a layer or an IoError, and a layer that was read is
// one that an overlay takes.
//
//   F bytes...             the file itself; F below 128 chooses the format
//   F P C (OOO V)...       a file that oblast wrote, changed: of the files that belong to it the P-th, C bytes cut off
//                          its end, and at each offset O (three bytes) the value V
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
  const std::string paths[] = {path_of(extension)};
  if (io::read(paths, {.threads = 1}).regions != regions)
    std::abort();  // changes to a file that cannot be read try little
  FileSet files{{extension, bytes_of(paths[0])}};
  for (const auto& entry : std::filesystem::directory_iterator(fuzz::scratch_folder())) {
    const std::string other = entry.path().extension().string();
    if (other != extension) files.push_back({other, bytes_of(entry.path())});
  }
  std::sort(files.begin() + 1, files.end(), [](const auto& a, const auto& b) { return a.extension < b.extension; });
  fuzz::empty_scratch_folder();
  return files;
}

FileSet changed(std::span<const std::uint8_t> bytes) {
  static const std::array originals = {written(".shp"), written(".fgb"), written(".gpkg"), written(".geojson")};
  FileSet files = originals[bytes[0] % originals.size()];
  if (bytes.size() < 3) return files;
  std::string& content = files[bytes[1] % files.size()].bytes;
  content.resize(content.size() - std::min<std::size_t>(bytes[2], content.size()));
  if (content.empty()) return files;
  for (auto change = bytes.subspan(3); change.size() >= 4; change = change.subspan(4)) {
    const std::size_t offset = change[0] * 0x10000u + change[1] * 0x100u + change[2];
    content[offset % content.size()] = static_cast<char>(change[3]);
  }
  return files;
}

FileSet files_from(std::span<const std::uint8_t> bytes) {
  constexpr const char* extensions[] = {".geojson", ".topojson", ".fgb", ".gpkg", ".shp", ".wkt"};
  if (bytes[0] >= 128) return changed(bytes);
  return {{extensions[bytes[0] % std::size(extensions)], std::string(bytes.begin() + 1, bytes.end())}};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t most_vertices = 2000;  // so that one input takes milliseconds
  if (size == 0) return 0;
  const FileSet files = files_from({data, size});
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
