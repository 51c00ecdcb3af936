#include "triangulation/constrain.h"

#include <oblast/error.h>

#include "base/call.h"
#include "base/call_memory.h"
#include "exact/orientation.h"
#include "triangulation/flip.h"
#include "triangulation/pocket.h"

namespace oblast::internal::triangulation {
namespace {

class Constraining {
 public:
  Constraining(Mesh& mesh, std::span<const Constraint> constraints)
      : mesh_(mesh), constraints_(constraints), leaving_(mesh.points.size(), none), pocket_(mesh, leaving_) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      for (std::uint32_t i = 0; i < 3; ++i)
        if (mesh.triangles[t].vertex[i] != infinite_vertex) leaving_[mesh.triangles[t].vertex[i]] = half_edge(t, i);
  }

  Array<HalfEdge> run() {
    Array<HalfEdge> sides(constraints_.size());
    Array<std::uint32_t> missing;
    Steps steps(constraints_.size());
    for (std::uint32_t k = 0; k < constraints_.size(); ++k) {
      steps();
      sides[k] = find(constraints_[k]);
      if (sides[k] == none)
        missing.push_back(k);
      else
        mark(sides[k]);
    }
    for (const std::uint32_t k : missing) {
      poll();
      insert(constraints_[k]);
    }
    // Pockets and flips may have moved sides that were found earlier.
    for (std::uint32_t k = 0; k < constraints_.size(); ++k) {
      steps();
      if (!is_at(sides[k], constraints_[k])) sides[k] = find(constraints_[k]);
    }
    return sides;
  }

 private:
  bool is_at(HalfEdge h, const Constraint& c) const {
    return h != none && mesh_.origin(h) == c.from && mesh_.target(h) == c.to;
  }

  void mark(HalfEdge h) {
    mesh_.set_constrained(h);
    mesh_.set_constrained(mesh_.twin(h));
  }

  /// The side from c.from to c.to, or none. Looks around both ends in step, so the cost is the
  /// smaller of the two degrees: a hub with many spokes stays linear.
  HalfEdge find(const Constraint& c) const {
    const HalfEdge first_from = leaving_[c.from], first_to = leaving_[c.to];
    HalfEdge h = first_from, g = first_to;
    do {
      if (mesh_.target(h) == c.to) return h;
      if (mesh_.target(g) == c.from) return mesh_.twin(g);
      h = mesh_.clockwise(h);
      g = mesh_.clockwise(g);
    } while (h != first_from && g != first_to);
    return none;
  }

  void insert(const Constraint& c) {
    if (const HalfEdge h = find(c); h != none) return mark(h);  // a pocket made it a side meanwhile
    const HalfEdge crossed = first_crossed(c);
    take_crossed(mesh_.apex(crossed) == c.from ? c : Constraint{c.to, c.from}, crossed);
    suspects_.clear();
    pocket_.fill(suspects_);
    make_delaunay(mesh_, leaving_, suspects_);
  }

  /// The side through which the constraint leaves its first or its last triangle. Searches around both ends in
  /// parallel.
  HalfEdge first_crossed(const Constraint& c) const {
    const HalfEdge first_from = leaving_[c.from], first_to = leaving_[c.to];
    HalfEdge h = first_from, g = first_to;
    bool all_from = false, all_to = false;
    while (!all_from || !all_to) {
      if (is_between(c.from, c.to, next(h))) return next(h);
      if (is_between(c.to, c.from, next(g))) return next(g);
      h = mesh_.clockwise(h);
      g = mesh_.clockwise(g);
      all_from |= h == first_from;
      all_to |= g == first_to;
    }
    throw_crossing();
  }

  /// True if the ray passes through the side. The start of the ray is the apex of the side.
  bool is_between(std::uint32_t from, std::uint32_t to, HalfEdge side) const {
    const std::uint32_t p = mesh_.origin(side), q = mesh_.target(side);
    if (p == infinite_vertex || q == infinite_vertex) return false;
    return orientation(from, to, p) < 0 && orientation(from, to, q) > 0;
  }

  int orientation(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return exact::orientation(mesh_.points[a], mesh_.points[b], mesh_.points[c]);
  }

  /// Gives the pocket all triangles through which the constraint passes.
  ///
  ///            q ------- ...        h: from p to q, the last side crossed
  ///          / | \   left
  ///     from --+--r--------- to     r: the vertex beyond it, here on the right
  ///          \ | /   right
  ///            p
  void take_crossed(const Constraint& c, HalfEdge h) {
    pocket_.begin(c.from, c.to);
    pocket_.take(triangle_of(h));
    pocket_.add_right(previous(h));
    pocket_.add_left(next(h));
    for (;;) {
      if (mesh_.is_constrained(h)) throw_crossing();
      const HalfEdge g = mesh_.twin(h), pr = next(g), rq = previous(g);
      const std::uint32_t r = mesh_.apex(g);
      if (r == infinite_vertex) throw_crossing();
      pocket_.take(triangle_of(g));
      const int side = r == c.to ? 0 : orientation(c.from, c.to, r);
      if (side == 0 && r != c.to) throw_crossing();
      if (side >= 0) pocket_.add_left(rq);
      if (side <= 0) pocket_.add_right(pr);
      if (side == 0) return;
      h = side > 0 ? pr : rq;
    }
  }

  [[noreturn]] static void throw_crossing() {
    throw Error(ErrorCode::precondition,
                "sides of the regions cross each other or pass through a vertex; unite the regions first "
                "(TriangleInput::any does this)");
  }

  Mesh& mesh_;
  std::span<const Constraint> constraints_;
  Array<HalfEdge> leaving_;  ///< by vertex: some half-edge with that origin
  Pocket pocket_;
  Array<HalfEdge> suspects_;
};

}  // namespace

Array<HalfEdge> constrain(Mesh& mesh, std::span<const Constraint> constraints) {
  return Constraining(mesh, constraints).run();
}

}  // namespace oblast::internal::triangulation
