// Triangulation: a triangulation of the hull, Delaunay as far as the sides allow, every triangle in its polygon,
// exactly; that of the interior is the part of it that lies in polygons; a result is taken as it is.
#include <oblast/triangulate.h>

#include <algorithm>

#include "bytes_to_operands.h"
#include "support/check_mesh.h"

namespace {

using namespace oblast;

std::vector<std::uint32_t> polygons_of(const Triangulation& mesh) {
  std::vector<std::uint32_t> polygons;
  std::copy_if(mesh.polygon.begin(), mesh.polygon.end(), std::back_inserter(polygons),
               [](std::uint32_t polygon) { return polygon != Triangulation::none; });
  std::sort(polygons.begin(), polygons.end());
  return polygons;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const fuzz::Input input = fuzz::input_from(bytes, size);
  const auto expect = [&](bool holds, const std::string& what) {
    if (!holds) fuzz::report({generators::Broken::wrong, Operation::unite, what}, input);
  };
  TriangulateOptions options;
  options.extent = TriangleExtent::convex_hull;
  options.fill_a = input.request.fill_a;
  const Triangulation whole = triangulate(input.operands.a, options);
  const auto fault = testing::check_triangulation(whole);
  expect(!fault, fault.value_or(""));

  options.input = TriangleInput::result;
  expect(triangulate(whole.regions, options).triangles == whole.triangles, "a result is triangulated differently");

  options.extent = TriangleExtent::interior;
  const Triangulation interior = triangulate(whole.regions, options);
  expect(interior.triangles.size() == interior.polygon.size() && polygons_of(interior) == polygons_of(whole) &&
             polygons_of(interior).size() == interior.triangles.size(),
         "the interior has other triangles than the hull");
  return 0;
}
