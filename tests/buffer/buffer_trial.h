// One hostile case of a buffer zone, and whether every promise held.
#pragma once

#include <oblast/buffer.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generators/hostile.h"

namespace oblast::testing {

enum class BrokenBuffer { closed, bounds, order, far, threads, monotone, rows, threw };
inline constexpr int broken_buffer_count = 8;
const char* to_text(BrokenBuffer broken);

struct BufferFailure {
  BrokenBuffer broken;
  std::string what;
};

/// Shapes that own their arrays.
struct OwnedShapes {
  RegionSet regions;
  std::vector<Point> line_points, points;
  std::vector<std::uint32_t> line_ends;

  ShapeView view() const { return {regions, {line_points, line_ends}, points}; }
};

/// The worst figures of a run.
struct BufferFigures {
  double nearest = 0;   ///< largest shortfall: (lower bound - nearest distance) / bound; below 0 when all is well
  double furthest = 0;  ///< largest distance by the upper bound; at most 1 when all is well
  std::uint64_t folded = 0, pockets = 0;

  void add(const BufferFigures& other);
};

/// A question drawn from the operands: A as regions, contours of B as lines, some vertices as points, with random
/// options and a distance from far below a unit in the last place to a thousand times the extent, of both signs.
/// closed: verify::check_result; bounds: verify::check_zone; order: shapes in another order and direction; far: with
/// shapes elsewhere; threads: two of them; monotone: a larger distance; rows: the same as a row.
struct BufferQuestion {
  OwnedShapes shapes;
  double distance = 0;
  BufferOptions options;
};
BufferQuestion draw_question(const generators::Operands& operands, std::uint64_t seed);
std::optional<BufferFailure> run_buffer_trial(const BufferQuestion& question, std::uint64_t seed,
                                              BufferFigures* figures = nullptr);
/// The question in words, to ask it again.
std::string to_text(const BufferQuestion& question);

}  // namespace oblast::testing
