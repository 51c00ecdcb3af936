// The generated workloads, and the tests iOverlay publishes. All are functions of a size and a seed alone; the sizes
// are explained at each.
#pragma once

#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "workloads/workload_file.h"

namespace oblast::bench {

struct NamedWorkload {
  const char* name;
  const char* size;  ///< what SIZE means
  Workload (*make)(std::uint32_t size, std::uint64_t seed);
};

/// Every generated workload, by name.
std::span<const NamedWorkload> general_workloads();   // general.cpp
std::span<const NamedWorkload> window_workloads();    // windows.cpp
std::span<const NamedWorkload> ioverlay_workloads();  // ioverlay_tests.cpp
/// The one of that name; null where there is none.
const NamedWorkload* find_workload(std::string_view name);

/// A uniform number in [0, 1), the same on every machine (std::uniform_real_distribution is not).
inline double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

/// Appends a polygon of one contour.
void add_polygon(RegionSet& regions, std::span<const Point> contour);
/// Appends another contour to the last polygon.
void add_hole(RegionSet& regions, std::span<const Point> contour);
/// Appends the axis-parallel rectangle [x0, x1] x [y0, y1].
void add_rectangle(RegionSet& regions, double x0, double y0, double x1, double y1);

/// A simple contour of n vertices about the origin, radius 1000: waves large and small, and a wiggle of each vertex.
std::vector<Point> wiggly_star(std::uint32_t n, double phase, std::mt19937_64& random);

/// A workload of one pair; contours are oriented unless they cross.
Workload single(Operation operation, RegionSet a, RegionSet b, OperandKind kind_a = OperandKind::region_set,
                OperandKind kind_b = OperandKind::region_set, FillRule::Kind fill = FillRule::Kind::polygons);

}  // namespace oblast::bench
