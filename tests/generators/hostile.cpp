// The list of hostile generators.
#include "generators/hostile.h"

#include <array>

namespace oblast::generators {

std::span<const HostileGenerator> hostile_generators() {
  static constexpr std::array<HostileGenerator, 19> list{{
      {"integer_grid", "random contours on a grid of a few integers", integer_grid},
      {"grid_by_an_ulp", "the same, each coordinate moved by at most one unit in the last place", grid_by_an_ulp, 60,
       500, 1200},
      {"copies_of_one_square", "one square many times, some copies nudged", copies_of_one_square, 60, 16000},
      {"nested_squares", "squares in squares, touching at corners", nested_squares, 60, 500, 3000},
      {"checkerboards", "cells that meet at corners, over shifted cells", checkerboards},
      {"near_parallel_bundles", "long thin contours that differ by a few units in the last place",
       near_parallel_bundles, 20, 60, 150},
      {"fans", "many edges at one vertex", fans, 60, 500, 3000},
      {"combs", "combs whose teeth meet in one point, or almost", combs, 60, 500, 700},
      {"stars", "contours that cross themselves many times near one point", stars, 60, 150, 500},
      {"t_junctions", "rows of cells along one line, divided differently on its two sides", t_junctions},
      {"vertices_on_edges", "every vertex on an edge of the other operand, up to rounding", vertices_on_edges},
      {"slivers", "a contour against itself with vertices added and nudged", slivers},
      {"coverages", "two divisions of one area with shared borders", coverages},
      {"spirals", "two spirals, one moved a little", spirals},
      {"magnitudes", "magnitudes from one end of the domain to the other, mixed", magnitudes, 60, 500, 1500},
      {"earth_degrees", "rotated pixels in degrees", earth_degrees},
      {"earth_metres", "rotated pixels in metres of a projection", earth_metres},
      {"far_from_origin", "small shapes whose coordinates keep few bits for them", far_from_origin, 60, 500, 800},
      {"fed_back", "the result of ten operations in a row, against something new", fed_back},
  }};
  return list;
}

}  // namespace oblast::generators
