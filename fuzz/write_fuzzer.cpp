// Writers: a result written in any format reads back to the same polygons with the same bits.
#include <oblast/overlay.h>

#include <string>

#include "bytes_to_operands.h"
#include "generators/request.h"
#include "io/read.h"
#include "io/write.h"
#include "scratch_folder.h"
#include "support/same_bits.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace oblast;
  constexpr const char* extensions[] = {".shp", ".gpkg", ".geojson", ".fgb", ".wkt", ".json"};
  const fuzz::Input input = fuzz::input_from(data, size);
  const RegionSet result = unite(input.operands.a, generators::options_of(input.request));
  const std::string extension = extensions[input.request.seed % std::size(extensions)];
  const std::string path = (fuzz::scratch_folder() / ("out" + extension)).string();
  io::write(path, result);
  const std::string paths[] = {path};
  if (!testing::same_bits(io::read(paths, {.threads = 1}).regions, result))
    fuzz::report({generators::Broken::wrong, Operation::unite, "reads back differently: " + extension}, input);
  fuzz::empty_scratch_folder();
  return 0;
}
