// Writers: a result written in any format reads back to the same polygons with the same bits.
#include <oblast/overlay.h>

#include <cstring>
#include <string>

#include "bytes_to_operands.h"
#include "generators/request.h"
#include "io/read.h"
#include "io/write.h"
#include "scratch_folder.h"

namespace {

using namespace oblast;

bool same_bits(const RegionSet& a, const RegionSet& b) {
  return a == b && (a.empty() || std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof(Point)) == 0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr const char* extensions[] = {".shp", ".gpkg", ".geojson", ".fgb", ".wkt", ".json"};
  const fuzz::Input input = fuzz::input_from(data, size);
  const RegionSet result = unite(input.operands.a, generators::options_of(input.request));
  const std::string extension = extensions[input.request.seed % std::size(extensions)];
  const std::string path = (fuzz::scratch_folder() / ("out" + extension)).string();
  io::write(path, result);
  const std::string paths[] = {path};
  if (!same_bits(io::read(paths, {.threads = 1}).regions, result))
    fuzz::report({generators::Broken::wrong, Operation::unite, "reads back differently: " + extension}, input);
  fuzz::empty_scratch_folder();
  return 0;
}
