// Triangulation: a triangulation of the hull, Delaunay as far as the sides allow, every triangle in its polygon,
// exactly.
#include <oblast/triangulate.h>

#include "bytes_to_operands.h"
#include "support/check_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace oblast;
  const fuzz::Input input = fuzz::input_from(bytes, size);
  TriangulateOptions options;
  options.extent = TriangleExtent::convex_hull;
  options.unite.fill_a = input.request.fill_a;
  if (const auto what = testing::check_triangulation(triangulate(input.operands.a, options)))
    fuzz::report({generators::Broken::wrong, Operation::unite, *what}, input);
  return 0;
}
