// Margalit and Knott 1989: vertex-complete polygons (Skvortsov, section 2.4).
//
// 1. Normalise: coincident sides cancel in pairs. The operation decides the directions: the interior is on the left of
// A,
//    and on the left of B, too, except on the right of B for the difference.
// 2. Find the intersections and insert them into both polygons: the sides become edge fragments.
// 3. Classify each fragment with respect to the other polygon: inside, outside, or on its boundary. The paper locates
// every
//    vertex and every midpoint separately, in O(n^2) in total. Here one sweep finds, for all fragments, which side of
//    the other polygon lies below them: the O(n log n) that Table 1 calls theoretical.
// 4. Select fragments by the table. 5. Construct contours from them.
//
//      operation      of A       of B      on the boundary: directed alike   directed oppositely
//      intersection   inside     inside    once                              -
//      union          outside    outside   once                              -
//      difference     outside    inside    once                              -
//
// For the difference B is reversed. Then boundaries with the same direction have their interiors on opposite sides. So
// one table is enough for all three operations.
#include <algorithm>

#include "base/call_memory.h"
#include "classics/arrangement.h"
#include "classics/settle.h"
#include "graph/locate_below.h"
#include "result/link.h"
#include "result/rings.h"
#include "window/contours.h"

namespace oblast {
using namespace internal;
namespace {

using classics::Ring;

constexpr const char* name = "Margalit-Knott";
constexpr const char* instead = "overlay";

enum class Place : std::uint8_t { outside, inside, on_boundary };

/// Step 1. Checks that the operand is vertex-complete.
Array<Ring> normalise(const RegionView& regions, std::size_t index, const CallOptions& call, bool& touches) {
  const classics::Operand operand{regions, index, name, instead};
  Array<Ring> rings{operand.one_contour()};
  const classics::OwnMeetings own = classics::find_own_meetings(rings);
  if (own.crossed_ring != none)
    operand.refuse("another edge crosses the edge from there, or ends inside it, so it is not vertex-complete", 0,
                   rings[0].source[own.crossed_vertex]);
  // Nothing is cut, so no coordinate changes. Coincident sides cancel, and the contour is divided into simple ones.
  const RegionSet normal = unite(regions, classics::overlay_options(call, FillRule::even_odd()));
  rings.clear();
  for (std::size_t c = 0; c < normal.contour_ends.size(); ++c)
    rings.push_back(classics::clean_ring(normal.view().contour(c)));
  touches = own.touches;
  return rings;
}

/// Steps 3 and 4.
class Fragments {
 public:
  Fragments(const ChainGraph& graph, Operation operation)
      : graph_(graph), b_turned_(operation == Operation::difference ? -1 : 1) {
    place_.assign(graph.chains.size(), Place::outside);
    classify(true);
    classify(false);
    selection_.assign(graph.chains.size(), none);
    for (std::uint32_t c = 0; c < selection_.size(); ++c)
      if (graph.is_live(c)) select(c, operation);
  }

  const Selection& selection() const { return selection_; }

 private:
  std::int32_t change(std::uint32_t c, bool of_a) const {
    return of_a ? graph_.chains[c].change.a : graph_.chains[c].change.b;
  }

  void classify(bool of_a) {
    Array<std::uint32_t> others, fragments;
    Array<BelowQuery> queries;
    for (std::uint32_t c = 0; c < graph_.chains.size(); ++c) {
      if (!graph_.is_live(c)) continue;
      if (change(c, !of_a) != 0) others.push_back(c);
      if (change(c, of_a) == 0) continue;
      if (change(c, !of_a) != 0) {
        place_[c] = Place::on_boundary;
        continue;
      }
      const Point p = graph_.point(graph_.chains[c].first), q = graph_.point(graph_.chains[c].first + 1);
      fragments.push_back(c);
      queries.push_back(lexicographically_less(p, q) ? BelowQuery{p, q} : BelowQuery{q, p});
    }
    const Array<Below> below = locate_below(graph_, others, queries);
    for (std::size_t i = 0; i < fragments.size(); ++i) {
      const bool inside = below[i].chain != none && (change(below[i].chain, !of_a) > 0) == below[i].rightward;
      place_[fragments[i]] = inside ? Place::inside : Place::outside;
    }
  }

  void select(std::uint32_t c, Operation operation) {
    const bool of_a = change(c, true) != 0;
    const std::int32_t directed = of_a ? change(c, true) : b_turned_ * change(c, false);
    bool selected = place_[c] == (operation == Operation::intersection ? Place::inside : Place::outside);
    if (operation == Operation::difference && !of_a) selected = place_[c] == Place::inside;
    if (place_[c] == Place::on_boundary) selected = directed == b_turned_ * change(c, false);
    if (selected) selection_[c] = directed > 0 ? forward(c) : opposite(forward(c));
  }

  const ChainGraph& graph_;
  std::int32_t b_turned_;
  Array<Place> place_;
  Selection selection_;
};

/// Step 5.
RegionSet construct(const ChainGraph& graph, const Selection& selection) {
  const LinkedContours linked = link(graph, selection, ContourConvention::ogc);
  const Rings rings = contours_to_rings(graph, selection, linked);
  window::Contours contours;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    for (std::uint32_t v = rings.begin(r); v < rings.ends[r]; ++v) contours.add(rings.points[v]);
    contours.close();
  }
  return contours.to_region_set();
}

RegionSet run_margalit_knott(const RegionView& a, const RegionView& b, Operation operation, const CallOptions& options,
                             ClassicReport& done) {
  classics::refuse_symmetric_difference(operation == Operation::symmetric_difference, name);
  bool a_touches = false, b_touches = false;
  const Array<Ring> rings_a = normalise(a, 0, options, a_touches), rings_b = normalise(b, 1, options, b_touches);
  const classics::Arrangement arrangement = classics::arrange(rings_a, a_touches, rings_b, b_touches);
  done.meetings = arrangement.meetings;
  if (!arrangement.clear) return classics::settle(a, b, operation, done, classics::overlay_options(options));
  return construct(arrangement.graph, Fragments(arrangement.graph, operation).selection());
}

}  // namespace

RegionSet margalit_knott(const RegionView& a, const RegionView& b, Operation operation, ClassicReport* report,
                         const CallOptions& options) {
  check_operation(operation);
  return classics::classic_call(
      a, b, report, options, [&](ClassicReport& done) { return run_margalit_knott(a, b, operation, options, done); });
}

}  // namespace oblast
