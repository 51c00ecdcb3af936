// The workload file: one overlay, or many small ones, in a form that is easy to read for every driver.
//
//   header    magic "OBLWORK1"; then u32: operation, fill, kind of A, kind of B, flags, pairs
//   A, then B:
//     u64     points, contours, polygons
//     f64     x0 y0 x1 y1 ...
//     u32     contour ends, then polygon ends (0 to 4 bytes follow, up to a multiple of 8)
//     u64     for each pair: where its points, contours and polygons end
//
// Ends count from the beginning of their pair, so a pair is a RegionView of the arrays. Numbers are little-endian. The
// first contour of a polygon is its outer one. If no contours cross, outer contours run counter-clockwise and holes
// clockwise, so `polygons`, `nonzero` and OGC readers agree. Drivers write results in the same form, with an empty B.
#pragma once

#include <oblast/options.h>
#include <oblast/region_set.h>

#include <cstdint>
#include <string>
#include <vector>

namespace oblast::bench {

/// The properties of an operand on which a reader may rely.
enum class OperandKind : std::uint32_t {
  region_set,   ///< valid polygons that do not overlap
  overlapping,  ///< valid polygons; they may overlap, or share borders
  crossing,     ///< contours may cross themselves; the fill rule decides what is inside
};

/// The arrays of all pairs of one operand, one after another.
struct Operand {
  struct End {
    std::uint64_t point = 0, contour = 0, polygon = 0;
  };
  OperandKind kind = OperandKind::region_set;
  RegionSet arrays;
  std::vector<End> pair_ends;

  /// Appends one pair.
  void add(const RegionView& regions);
  RegionView pair(std::size_t index) const;
};

struct Workload {
  Operation operation = Operation::unite;  ///< with B empty: the union of A's polygons
  FillRule::Kind fill = FillRule::Kind::polygons;
  bool coverage = false;  ///< A's polygons share borders vertex by vertex and do not overlap
  Operand a, b;

  std::size_t pairs() const { return a.pair_ends.size(); }
};

/// These functions throw std::runtime_error, whose message names the file.
Workload read_workload(const std::string& path);
void write_workload(const std::string& path, const Workload& workload);

/// Turns outer contours counter-clockwise and holes clockwise.
void orient(RegionSet& regions);

/// The area of a set whose outer contours all have one direction and whose holes have the other.
double region_area(const RegionView& regions);

}  // namespace oblast::bench
