// Weiler and Atherton 1977: regular polygons with oriented contours (Skvortsov, section 2.3, figure 5).
//
// Idea: at the points where the boundaries meet, walk from one boundary to the other.
// 1. Find the intersections and insert them into both polygons.
// 2. Decide for each stretch of boundary between two intersections whether it runs inside or outside the other polygon.
// The
//    sectors at the intersection at which it starts decide this (entering and leaving).
// 3. Walk. Intersection: begin on a stretch inside the other polygon, walk to the next intersection, change to the
// other
//    boundary, and repeat until the path closes. Union: the same on stretches outside. Difference: on A's stretches
//    outside B, and backward on B's stretches inside A.
//
// The paper leaves degenerate cases open. Here coincident stretches are SHARED1 (same direction) or SHARED2 (opposite
// directions). At an intersection of many stretches, the walk leaves by the first admitted one clockwise from the one
// by which it arrived, so it never crosses itself.
#include <algorithm>

#include "base/call_memory.h"
#include "classics/arrangement.h"
#include "classics/settle.h"
#include "graph/locate_below.h"
#include "window/contours.h"

namespace oblast {
using namespace internal;
namespace {

constexpr const char* name = "Weiler-Atherton";
constexpr const char* instead = "overlay";

enum class Side : std::uint8_t { unknown, inside, outside, shared1, shared2 };

bool of_a(Winding w) { return w.a != 0; }

/// All stretches, given by their chains, with their position with respect to the other polygon.
class Stretches {
 public:
  explicit Stretches(const ChainGraph& graph) : graph_(graph), side_(graph.chains.size(), Side::unknown) {
    for (std::uint32_t node = 0; node < graph.node_count(); ++node) classify_at(node);
    spread();
    locate_the_rest();
  }

  Side operator[](std::uint32_t chain) const { return side_[chain]; }

 private:
  /// Step 2 at one intersection. Around it, sectors are inside or outside the other polygon. This changes only at
  /// stretches of the other polygon.
  void classify_at(std::uint32_t node) {
    const auto list = graph_.list(node);
    bool in_a = false, in_b = false, knows_a = false, knows_b = false;
    const auto pass = [&](Descriptor d) {
      const Winding w = graph_.change(d);
      if (w.a != 0) knows_a = true, in_a = w.a > 0;
      if (w.b != 0) knows_b = true, in_b = w.b > 0;
    };
    for (const Descriptor d : list) pass(d);
    for (const Descriptor d : list) {
      const Winding w = graph_.change(d);
      Side& side = side_[chain_of(d)];
      if (w.a != 0 && w.b != 0)
        side = w.a == w.b ? Side::shared1 : Side::shared2;
      else if (of_a(w) ? knows_b : knows_a)
        side = (of_a(w) ? in_b : in_a) ? Side::inside : Side::outside;
      pass(d);
    }
  }

  /// At a point where only one polygon touches itself, all its stretches have the same position to the other polygon.
  void spread() {
    Array<std::uint32_t> known;
    for (std::uint32_t c = 0; c < side_.size(); ++c)
      if (side_[c] == Side::inside || side_[c] == Side::outside) known.push_back(c);
    spread_from(known);
  }

  void spread_from(Array<std::uint32_t>& known) {
    while (!known.empty()) {
      const std::uint32_t c = known.back();
      known.pop_back();
      if (graph_.chains[c].is_loop()) continue;
      for (const std::uint32_t node : {graph_.chains[c].from, graph_.chains[c].to})
        for (const Descriptor d : graph_.list(node)) {
          if (side_[chain_of(d)] != Side::unknown) continue;
          side_[chain_of(d)] = side_[c];
          known.push_back(chain_of(d));
        }
    }
  }

  /// Contours that meet nothing: the chain below a point decides whether it is in the other polygon.
  void locate_the_rest() {
    for (const bool in_a : {true, false}) {
      Array<std::uint32_t> others, unknown;
      Array<BelowQuery> queries;
      for (std::uint32_t c = 0; c < side_.size(); ++c) {
        if (!graph_.is_live(c)) continue;
        const Winding w = graph_.chains[c].change;
        if ((in_a ? w.b : w.a) != 0) others.push_back(c);
        if (side_[c] != Side::unknown || of_a(w) != in_a) continue;
        const Point p = graph_.point(graph_.chains[c].first), q = graph_.point(graph_.chains[c].first + 1);
        unknown.push_back(c);
        queries.push_back(lexicographically_less(p, q) ? BelowQuery{p, q} : BelowQuery{q, p});
      }
      const Array<Below> below = locate_below(graph_, others, queries);
      for (std::size_t i = 0; i < unknown.size(); ++i) {
        bool inside = false;
        if (below[i].chain != none) {
          const Winding w = graph_.chains[below[i].chain].change;
          inside = ((in_a ? w.b : w.a) > 0) == below[i].rightward;
        }
        side_[unknown[i]] = inside ? Side::inside : Side::outside;
      }
    }
  }

  const ChainGraph& graph_;
  Array<Side> side_;
};

/// Step 3.
class Walk {
 public:
  Walk(const ChainGraph& graph, const Stretches& stretches, Operation operation) : graph_(graph) {
    way_.assign(graph.chains.size(), none);
    for (std::uint32_t c = 0; c < way_.size(); ++c)
      if (graph.is_live(c)) way_[c] = admitted(c, stretches[c], operation);
  }

  window::Contours run() {
    window::Contours contours;
    for (std::uint32_t c = 0; c < way_.size(); ++c) {
      if (way_[c] == none) continue;
      for (Descriptor d = way_[c]; d != none; d = leave_from(graph_.chains[chain_of(d)].is_loop() ? none : d)) {
        add_stretch(d, contours);
        way_[chain_of(d)] = none;
      }
      contours.close();
    }
    return contours;
  }

 private:
  /// The direction in which a stretch is walked, if at all: the table of Leonov and Nikitin.
  Descriptor admitted(std::uint32_t c, Side side, Operation operation) const {
    const Winding w = graph_.chains[c].change;
    const bool interior_left = (of_a(w) ? w.a : w.b) > 0;  // A decides for a shared chain
    const Descriptor along = interior_left ? forward(c) : opposite(forward(c));
    switch (operation) {
      case Operation::intersection:
        return side == Side::inside || side == Side::shared1 ? along : none;
      case Operation::unite:
        return side == Side::outside || side == Side::shared1 ? along : none;
      default:
        if (of_a(w)) return side == Side::outside || side == Side::shared2 ? along : none;
        return side == Side::inside ? opposite(along) : none;
    }
  }

  /// After arriving along d: the first admitted stretch clockwise, or none if the path has closed.
  Descriptor leave_from(Descriptor d) const {
    if (d == none) return none;
    const auto list = graph_.list(graph_.end_node(d));
    const auto arrival = static_cast<std::size_t>(std::find(list.begin(), list.end(), opposite(d)) - list.begin());
    for (std::size_t i = 1; i < list.size(); ++i) {
      const Descriptor e = list[(arrival + list.size() - i) % list.size()];
      if (way_[chain_of(e)] == e) return e;
    }
    return none;
  }

  void add_stretch(Descriptor d, window::Contours& contours) const {
    const Chain& chain = graph_.chains[chain_of(d)];
    if (is_backward(d))
      for (std::uint32_t v = chain.last; v > chain.first; --v) contours.add(graph_.point(v));
    else
      for (std::uint32_t v = chain.first; v < chain.last; ++v) contours.add(graph_.point(v));
  }

  const ChainGraph& graph_;
  Array<Descriptor> way_;
};

/// An operand whose contours all have the interior on one side, reversed if necessary, so that it is the left side.
struct Oriented {
  Array<classics::Ring> rings;
  bool touches = false;
  FillRule rule = FillRule::positive();  ///< the fill rule for the contours of the input
};

Oriented require_oriented(const RegionView& regions, std::size_t index) {
  const classics::Operand operand{regions, index, name, instead};
  Oriented oriented;
  oriented.rings = operand.all_contours();
  const classics::OwnMeetings own = classics::require_regular(operand, oriented.rings);
  oriented.touches = own.touches;
  bool interior_left = true;
  classics::require_one_side(operand, oriented.rings, own,
                             "the interior is not on the same side of this contour as of the first contour",
                             interior_left);
  if (!interior_left) {
    for (classics::Ring& ring : oriented.rings) classics::reverse(ring);
    oriented.rule = FillRule::negative();
  }
  return oriented;
}

RegionSet run_weiler_atherton(const RegionView& a, const RegionView& b, Operation operation, const CallOptions& call,
                              ClassicReport& done) {
  classics::refuse_symmetric_difference(operation == Operation::symmetric_difference, name);
  const Oriented oriented_a = require_oriented(a, 0), oriented_b = require_oriented(b, 1);
  const classics::Arrangement arrangement =
      classics::arrange(oriented_a.rings, oriented_a.touches, oriented_b.rings, oriented_b.touches);
  done.meetings = arrangement.meetings;
  if (!arrangement.clear) {
    Options options = classics::overlay_options(call, oriented_a.rule);
    options.fill_b = oriented_b.rule;
    return classics::settle(a, b, operation, done, options);
  }
  return Walk(arrangement.graph, Stretches(arrangement.graph), operation).run().to_region_set();
}

}  // namespace

RegionSet weiler_atherton(const RegionView& a, const RegionView& b, Operation operation, ClassicReport* report,
                          const CallOptions& options) {
  check_operation(operation);
  return classics::classic_call(
      a, b, report, options, [&](ClassicReport& done) { return run_weiler_atherton(a, b, operation, options, done); });
}

}  // namespace oblast
