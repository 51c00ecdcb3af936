// WKT: any text is either refused with an IoError or read; what was read is written and reads back to the
// same bits.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "io/read.h"
#include "io/write.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace oblast;
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  io::Layer layer;
  try {
    layer = io::read_wkt(text, "fuzz");
  } catch (const io::IoError&) {
    return 0;
  }
  if (layer.regions.empty()) return 0;
  const std::string written = io::to_wkt(layer.regions);
  const io::Layer again = io::read_wkt(written, "written");
  if (again.regions.points != layer.regions.points) {
    std::fprintf(stderr, "reads back differently: %s\n", written.c_str());
    std::abort();
  }
  return 0;
}
