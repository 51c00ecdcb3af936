// O'Rourke, Chien, Olson and Naddor 1982: convex with convex (Skvortsov, section 2.1, figure 3).
//
// Idea: two edges, one of each contour, advance around the contours. The edge that aims at the other's line advances,
// so neither passes a meeting. After at most 2(n1 + n2) advances all meetings are found. They divide both contours into
// chains. Two convex boundaries visit their common points in the same order. So between two of these points, p and q,
// lies one chain of each contour:
//
//              .--- B ---.            intersection: the left chain of each pair (here B's)
//        p ---+           +--- q      union: the right chain
//              `--- A ---'            difference A \ B: both chains, if A's is the right one
//
// (walked counter-clockwise, so the interiors are above). The sectors at p decide which chain is the left one.
#include <algorithm>
#include <array>

#include "base/call_memory.h"
#include "classics/clearance.h"
#include "classics/convex_meetings.h"
#include "classics/operand.h"
#include "classics/settle.h"
#include "exact/orientation.h"
#include "window/contours.h"

namespace oblast {
using namespace internal;
namespace {

using classics::ConvexMeetings;
using classics::NodedContour;
using exact::orientation;

constexpr const char* name = "O'Rourke";
constexpr const char* instead = "Weiler-Atherton or overlay";

/// Where a chain of one contour is with respect to the other region: the labels of Leonov and Nikitin.
enum class Label { inside, outside, shared1, shared2 };

/// The label of a chain that leaves x towards p, for a convex region whose boundary comes from `before` and goes to
/// `after`.
Label label_at(const Point& x, const Point& p, const Point& after, const Point& before) {
  if (p == after) return Label::shared1;
  if (p == before) return Label::shared2;
  const bool in_sector = orientation(x, after, p) > 0 && orientation(x, before, p) < 0;
  return in_sector ? Label::inside : Label::outside;
}

/// Both contours with their chains: chain k of A runs from node k to node k + 1, as does chain k of B.
class Lenses {
 public:
  Lenses(const NodedContour& a, const NodedContour& b, bool same_order) : a_(a), b_(b) {
    const std::size_t m = a.nodes.size();
    // Contours that touch from outside along an edge visit their nodes in opposite order.
    for (std::size_t k = 0; k < m; ++k) {
      const std::uint32_t i = a.nodes[k], j = b.nodes[same_order ? k : m - 1 - k];
      const Point& x = a.points[i];
      a_label_.push_back(label_at(x, a.next(i), b.next(j), b.previous(j)));
      b_label_.push_back(label_at(x, b.next(j), a.next(i), a.previous(i)));
    }
    const auto meets_interior = [](Label l) { return l == Label::inside || l == Label::shared1; };
    interiors_meet_ = std::any_of(a_label_.begin(), a_label_.end(), meets_interior) ||
                      std::any_of(b_label_.begin(), b_label_.end(), meets_interior);
    if (!same_order) std::reverse(b_label_.begin(), b_label_.end());
  }

  window::Contours intersection() const {
    window::Contours result;
    if (!interiors_meet_) return result;
    for (std::size_t k = 0; k < a_label_.size(); ++k)
      a_label_[k] == Label::outside ? b_.add_chain(k, result) : a_.add_chain(k, result);
    result.close();
    return result;
  }

  window::Contours unite() const {
    window::Contours result;
    if (interiors_meet_) {
      for (std::size_t k = 0; k < a_label_.size(); ++k)
        a_label_[k] == Label::inside ? b_.add_chain(k, result) : a_.add_chain(k, result);
      result.close();
      return result;
    }
    // They touch from outside: at one point, or along an edge. Then one chain of each remains.
    const bool along_an_edge = std::find(a_label_.begin(), a_label_.end(), Label::shared2) != a_label_.end();
    add_unshared(a_, a_label_, result);
    if (!along_an_edge) result.close();
    add_unshared(b_, b_label_, result);
    result.close();
    return result;
  }

  window::Contours difference() const {
    window::Contours result;
    if (!interiors_meet_) {
      for (std::size_t k = 0; k < a_label_.size(); ++k) a_.add_chain(k, result);
      result.close();
      return result;
    }
    for (std::size_t k = 0; k < a_label_.size(); ++k) {
      if (a_label_[k] != Label::outside) continue;
      a_.add_chain(k, result);
      if (a_label_.size() == 1) result.close();  // B in A, touching it once: a hole
      b_.add_chain_backward(k, result);
      result.close();
    }
    return result;
  }

 private:
  static void add_unshared(const NodedContour& contour, const Array<Label>& labels, window::Contours& result) {
    for (std::size_t k = 0; k < labels.size(); ++k)
      if (labels[k] != Label::shared2) contour.add_chain(k, result);
  }

  const NodedContour &a_, &b_;
  Array<Label> a_label_, b_label_;
  bool interiors_meet_ = false;
};

bool contains(const classics::Ring& ring, const Point& p) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (orientation(ring.points[i], ring.next(i), p) <= 0) return false;
  return true;
}

void add_ring(const classics::Ring& ring, bool backward, window::Contours& result) {
  for (std::size_t i = 0; i < ring.size(); ++i) result.add(ring.points[backward ? ring.size() - 1 - i : i]);
  result.close();
}

/// For boundaries that do not meet: the regions are disjoint, or one is inside the other.
window::Contours without_meetings(const classics::Ring& a, const classics::Ring& b, Operation operation) {
  const bool a_in_b = contains(b, a.points[0]), b_in_a = !a_in_b && contains(a, b.points[0]);
  window::Contours result;
  if (operation == Operation::intersection) {
    if (a_in_b) add_ring(a, false, result);
    if (b_in_a) add_ring(b, false, result);
  } else if (operation == Operation::unite) {
    if (!a_in_b) add_ring(a, false, result);
    if (!b_in_a) add_ring(b, false, result);
  } else if (!a_in_b) {
    add_ring(a, false, result);
    if (b_in_a) add_ring(b, true, result);
  }
  return result;
}

RegionSet run_orourke(const RegionView& a, const RegionView& b, Operation operation, const CallOptions& options,
                      ClassicReport& done) {
  classics::refuse_symmetric_difference(operation == Operation::symmetric_difference, name);
  const classics::Ring ring_a = classics::Operand{a, 0, name, instead}.one_convex_contour();
  const classics::Ring ring_b = classics::Operand{b, 1, name, instead}.one_convex_contour();

  ConvexMeetings meetings(ring_a, ring_b);
  done.steps = meetings.find();
  const auto order = meetings.settled_order();
  done.meetings = meetings.contour_a().nodes.size();
  if (order == ConvexMeetings::Order::unsettled)
    return classics::settle(a, b, operation, done, classics::overlay_options(options));
  if (done.meetings == 0) return without_meetings(ring_a, ring_b, operation).to_region_set();

  const Lenses lenses(meetings.contour_a(), meetings.contour_b(), order == ConvexMeetings::Order::same);
  switch (operation) {
    case Operation::intersection:
      return lenses.intersection().to_region_set();
    case Operation::unite:
      return lenses.unite().to_region_set();
    default:
      return lenses.difference().to_region_set();
  }
}

}  // namespace

RegionSet orourke(const RegionView& a, const RegionView& b, Operation operation, ClassicReport* report,
                  const CallOptions& options) {
  check_operation(operation);
  return classics::classic_call(a, b, report, options,
                                [&](ClassicReport& done) { return run_orourke(a, b, operation, options, done); });
}

}  // namespace oblast
