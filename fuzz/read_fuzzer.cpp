// Readers on mutated files: whatever the bytes, reading ends with a layer or an IoError. The first byte
// chooses the format.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "io/read.h"

namespace {

// One folder a process: fuzzers run side by side.
const std::filesystem::path& folder() {
  static const std::filesystem::path made = [] {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("oblast-read-fuzzer-" + std::to_string(getpid()));
    std::filesystem::create_directories(path);
    return path;
  }();
  return made;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  constexpr const char* extensions[] = {".geojson", ".topojson", ".fgb", ".gpkg", ".shp", ".wkt"};
  if (size == 0) return 0;
  const std::filesystem::path path = folder() / ("input" + std::string(extensions[bytes[0] % std::size(extensions)]));
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes) + 1, static_cast<std::streamsize>(size - 1));
  try {
    const std::string paths[] = {path.string()};
    oblast::io::read(paths, {.threads = 1});
  } catch (const oblast::io::IoError&) {
  }
  std::filesystem::remove(path);
  return 0;
}
