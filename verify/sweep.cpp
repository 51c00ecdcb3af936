// Planarity and topology by one sweep: Shamos and Hoey 1976, with exact predicates.
//
// A line sweeps the plane from left to right. It is tilted by an infinitesimal angle, so it passes the vertices in
// lexicographic order, and no edge is parallel to it. The *status* is the list of edges that it crosses, from bottom to
// top. At each vertex position p, the edges that end there are removed, those that begin there are inserted, and every
// pair of new neighbours is tested. Let q be the smallest point at which two edges meet badly (other than at common
// ends). Up to q, the status is sorted, and the edges that reach q are consecutive in it. Two of them that meet badly
// at q are neighbours before q or become neighbours at q. So no bad meeting is missed.
//
// Between two neighbours of the status lies a piece of one face of the plane. The upper side of the edge below and the
// lower side of the edge above must have the same owner: a polygon or none. The left side of an edge belongs to its
// polygon, the right side to none. If all pieces agree, every point of the plane has one owner: interiors are disjoint,
// and lie on the left of all their edges.
//
//        ---------- above: its lower side  \   must have
//          piece                            >  the same
//        ---------- below: its upper side  /   owner
//
// Pieces of one face are connected through the edges that they share. So joining `below` and `above` of all pieces of a
// polygon (union-find) gives one set for each face. An edge has a face of its polygon on one side only. So a polygon is
// connected if and only if all its edges are in one set.
#include "verify/sweep.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "verify/predicates.h"

namespace oblast::verify {
namespace {

constexpr std::uint32_t nobody = static_cast<std::uint32_t>(-1);

// The order of the status, from bottom to top. Edges that meet badly at the left end of the newer one compare as equal,
// so the insertion finds them.
struct Below {
  const Edges* edges;

  bool operator()(std::uint32_t e, std::uint32_t f) const {
    if (e == f) return false;
    return stands_below(edges->left_end(e), edges->right_end(e), edges->left_end(f), edges->right_end(f));
  }
};

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) { parent_[find(i)] = find(j); }

 private:
  std::vector<std::uint32_t> parent_;
};

class Sweep {
 public:
  explicit Sweep(const Edges& edges) : edges_(edges), status_(Below{&edges}), faces_(edges.size()) {}

  std::optional<Fault> run() {
    sort_vertices();
    position_.resize(edges_.size());
    for (auto first = order_.begin(); first != order_.end();) {
      const Point p = edges_.from(*first);
      const auto last = std::find_if(first, order_.end(), [&](std::uint32_t v) { return edges_.from(v) != p; });
      if (auto fault = pass(p, first, last)) return fault;
      first = last;
    }
    if (wrong_side_) return wrong_side_;
    return check_connected();
  }

 private:
  using Status = std::set<std::uint32_t, Below>;
  using Vertices = std::vector<std::uint32_t>::const_iterator;

  void sort_vertices() {
    previous_.resize(edges_.size());
    for (std::uint32_t e = 0; e < edges_.size(); ++e) previous_[edges_.next[e]] = e;
    order_.resize(edges_.size());
    std::iota(order_.begin(), order_.end(), 0u);
    std::sort(order_.begin(), order_.end(),
              [&](std::uint32_t v, std::uint32_t w) { return lexicographically_less(edges_.from(v), edges_.from(w)); });
  }

  // Moves the line past position p, at which all vertices of [first, last) lie.
  std::optional<Fault> pass(const Point& p, Vertices first, Vertices last) {
    // Edges that end at p are consecutive. At the end `above` is the edge directly above them.
    auto above = status_.end();
    bool any_left = false;
    for (auto v = first; v != last; ++v) {
      for (const std::uint32_t e : {previous_[*v], *v}) {
        if (edges_.right_end(e) != p) continue;
        const bool moves = !any_left || above == position_[e];
        const auto after = status_.erase(position_[e]);
        if (moves) above = after;
        any_left = true;
      }
    }
    for (auto v = first; v != last; ++v) {
      for (const std::uint32_t e : {previous_[*v], *v}) {
        if (edges_.left_end(e) != p) continue;
        const auto [place, is_new] = status_.insert(e);
        if (!is_new) return bad_meeting(*place, e);
        position_[e] = above = place;
      }
    }
    return check_neighbours(p, above);
  }

  // Tests all pairs of neighbours that are new at p, from the edge below the edges that begin at p to the edge above
  // them.
  std::optional<Fault> check_neighbours(const Point& p, Status::iterator above) {
    const auto begins_here = [&](Status::iterator e) { return edges_.left_end(*e) == p; };
    while (above != status_.begin() && begins_here(std::prev(above))) --above;
    while (true) {
      const std::uint32_t low = above == status_.begin() ? nobody : *std::prev(above);
      const std::uint32_t high = above == status_.end() ? nobody : *above;
      if (auto fault = check_piece(low, high)) return fault;
      if (above == status_.end() || !begins_here(above)) return std::nullopt;
      ++above;
    }
  }

  std::optional<Fault> check_piece(std::uint32_t low, std::uint32_t high) {
    if (low != nobody && high != nobody &&
        meet_badly(edges_.from(low), edges_.to(low), edges_.from(high), edges_.to(high))) {
      return bad_meeting(low, high);
    }
    const std::uint32_t owner_low = low != nobody && edges_.forward(low) ? edges_.polygon_of_edge(low) : nobody;
    const std::uint32_t owner_high = high != nobody && !edges_.forward(high) ? edges_.polygon_of_edge(high) : nobody;
    if (owner_low != owner_high && !wrong_side_) wrong_side_ = wrong_side(low, high);
    if (owner_low == owner_high && owner_low != nobody) faces_.join(low, high);
    return std::nullopt;
  }

  std::optional<Fault> check_connected() {
    std::vector<std::uint32_t> face_of(edges_.regions.polygon_count(), nobody);
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      std::uint32_t& face = face_of[edges_.polygon_of_edge(e)];
      if (face == nobody) face = faces_.find(e);
      if (face != faces_.find(e)) {
        return edges_.fault_at(e, "the interior of the polygon is not connected: the part along " + name(e) +
                                      " is cut off from the one along " + name(face));
      }
    }
    return std::nullopt;
  }

  std::string name(std::uint32_t e) const { return to_text(edges_.from(e)) + " -> " + to_text(edges_.to(e)); }

  Fault bad_meeting(std::uint32_t e, std::uint32_t f) const {
    return edges_.fault_at(e, "edge " + name(e) + " crosses, touches or overlaps edge " + name(f) +
                                  " elsewhere than at a common end point");
  }

  Fault wrong_side(std::uint32_t low, std::uint32_t high) const {
    if (low == nobody || high == nobody) {
      const std::uint32_t e = low == nobody ? high : low;
      return edges_.fault_at(e, "the interior is not on the left of edge " + name(e) + ": the far side is outside");
    }
    return edges_.fault_at(low, "between edge " + name(low) + " and edge " + name(high) +
                                    " above it polygons overlap or a contour has its interior on the wrong side");
  }

  const Edges& edges_;
  std::vector<std::uint32_t> previous_;  // the edge that ends at a vertex
  std::vector<std::uint32_t> order_;     // vertices in lexicographic order
  Status status_;
  std::vector<Status::iterator> position_;
  DisjointSets faces_;
  std::optional<Fault> wrong_side_;  // the first; edges that meet badly are reported before it
};

}  // namespace

std::optional<Fault> check_plane(const Edges& edges) { return Sweep(edges).run(); }

}  // namespace oblast::verify
