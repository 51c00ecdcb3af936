// The noder alone: its edges are settled, and what is chosen from them has exactly the areas that the winding numbers
// say.
#include "bytes_to_operands.h"
#include "generators/recomputation.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  constexpr std::size_t most_vertices = 60;  // the check is quadratic in the noded edges
  const oblast::fuzz::Input input = oblast::fuzz::input_from(bytes, size);
  if (input.operands.a.points.size() + input.operands.b.points.size() > most_vertices) return 0;
  if (const auto what = recompute_arrangement(input.operands, input.request)) {
    oblast::fuzz::report({oblast::generators::Broken::wrong, oblast::Operation::unite, *what}, input);
  }
  return 0;
}
