// Strands: what noding works on. A strand is a path of edges that all change the winding numbers alike.
//
//   points   a0 a1 a2 a3 a0 | b0 b1 | c0 c1 c2
//   ends                  5       7          10
//
// A contour enters as a closed strand (its first point repeated as its last). Where identical edges were
// merged it falls apart into open strands, and the merged edge is a strand of its own. Edge i runs from
// points[i] to points[i + 1]; the last vertex of a strand starts no edge.
#pragma once

#include <oblast/point.h>

#include <algorithm>
#include <atomic>
#include <cstdint>

#include "base/call_memory.h"
#include "base/index.h"
#include "base/large_pages.h"
#include "noding/source_changes.h"

namespace oblast::internal::noding {

/// How much the winding numbers of A and B grow when an edge, seen along its direction, is crossed from
/// its right to its left. Where rows are overlaid: a handle for each operand (source_changes.h), not to be added by +.
struct Winding {
  std::int32_t a = 0;
  std::int32_t b = 0;

  bool is_zero() const { return a == 0 && b == 0; }
  friend bool operator==(const Winding&, const Winding&) = default;
  friend Winding operator+(Winding p, Winding q) { return {sum(p.a, q.a), sum(p.b, q.b)}; }
  friend Winding operator-(Winding p, Winding q) { return p + -q; }
  friend Winding operator-(Winding p) { return {opposite(p.a), opposite(p.b)}; }

 private:
  // Sums wrap around. Winding numbers do not come so far, but sums of polygons' numbers may (window/contours.cpp).
  static std::int32_t sum(std::int32_t p, std::int32_t q) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(p) + static_cast<std::uint32_t>(q));
  }
  static std::int32_t opposite(std::int32_t p) { return static_cast<std::int32_t>(-static_cast<std::uint32_t>(p)); }
};

/// How the changes of identical edges are added.
struct ChangeRules {
  /// Operands of which only the parity of the winding number counts (even_odd). There a contour's direction means
  /// nothing, so two identical edges cancel whichever way they run.
  bool parity_a = false;
  bool parity_b = false;
  /// Where rows are overlaid: the changes are handles of lists in this table.
  SourceChanges* sources = nullptr;

  Winding sum(Winding p, Winding q) const {
    if (sources) return {sources->add(p.a, q.a), sources->add(p.b, q.b)};
    return p + q;
  }
  Winding reduce(Winding w) const { return {parity_a ? w.a & 1 : w.a, parity_b ? w.b & 1 : w.b}; }
};

/// What is known of a vertex; a set of bits.
enum VertexFlag : std::uint8_t {
  node_flag = 1,       ///< other edges meet here: a node of the graph
  added_flag = 2,      ///< put in by noding; not a vertex of the input
  moved_flag = 4,      ///< the edge that starts here is a piece that the last round made
  closed_flag = 8,     ///< first or last vertex of a closed strand
  near_flag = 16,      ///< the edge that starts here does not keep clear of all others (clearance.h)
  repeated_flag = 32,  ///< the edge that starts here is a piece with the ends of an earlier one (repeated_pieces.h)
};

/// Edges of one group are known not to meet each other except where they follow one another.
/// Edges of group 0 may meet anything.
using Group = std::uint32_t;
inline constexpr Group any_group = 0;

/// Whether the edges of a strand are known not to meet each other, but where they follow one another. It may be assumed
/// of a closed strand in its polygon's group; the first round of noding finds out (node.h).
enum class Simplicity : std::uint8_t { known, assumed };

struct Strands {
  LargeArray<Point> points;
  Array<std::uint8_t> flags;     ///< by vertex
  Array<std::uint32_t> origin;   ///< by vertex, once cut: input edge that an added vertex lies on
  Array<std::uint32_t> ends;     ///< by strand: past its last vertex
  Array<Winding> change;         ///< by strand
  Array<Group> group;            ///< by strand
  Array<Simplicity> simplicity;  ///< by strand
  ChangeRules rules;

  /// A vertex's flags while other threads may set some; add_flag() is how they do.
  std::uint8_t load_flags(std::uint32_t vertex) {
    return std::atomic_ref(flags[vertex]).load(std::memory_order_relaxed);
  }
  void add_flag(std::uint32_t vertex, VertexFlag flag) {
    const std::atomic_ref shared(flags[vertex]);
    if (!(shared.load(std::memory_order_relaxed) & flag)) shared.fetch_or(flag, std::memory_order_relaxed);
  }

  std::uint32_t begin(std::size_t strand) const { return strand == 0 ? 0 : ends[strand - 1]; }
  std::size_t size() const { return ends.size(); }

  /// Origins and flags stay as they are: they come with noding.
  void resize(std::size_t vertices, std::size_t count) {
    points.resize(vertices);
    ends.resize(count);
    change.resize(count);
    group.resize(count);
    simplicity.resize(count);
  }

  /// Ends the strand whose points were appended last.
  void close_strand(Winding winding, Group strand_group, Simplicity strand_simplicity = Simplicity::known) {
    ends.push_back(checked_index(points.size(), "vertices of strands"));
    change.push_back(winding);
    group.push_back(strand_group);
    simplicity.push_back(strand_simplicity);
  }
  bool has_assumed() const {
    return std::find(simplicity.begin(), simplicity.end(), Simplicity::assumed) != simplicity.end();
  }
  /// The strand that an edge or a vertex is in.
  std::size_t strand_of(std::uint32_t index) const {
    return static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), index) - ends.begin());
  }
};

}  // namespace oblast::internal::noding
