#include "zones/sampling.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/call.h"
#include "zones/checked_pieces.h"
#include "zones/distance.h"

namespace oblast::internal::zoning {
namespace {

/// A part of an edge between two sites.
struct Piece {
  std::uint32_t edge;
  double from, to;  ///< along the edge, from 0 to 1
};

class Sampling {
 public:
  Sampling(const Skeleton& skeleton, const Room& room) : skeleton_(skeleton), room_(room), diagram_(skeleton.contacts) {
    for (const Point& p : room.ring) add_site({p, none});
    for (const LonePoint& point : skeleton.points) add_site({point.at, point.object});
    site_of_vertex_.resize(skeleton.object_of_vertex.size(), none);
    for (std::uint32_t e = 0; e < skeleton.edges.size(); ++e) add_edge(e);
    site_of_vertex_ = {};
  }

  Sampled run() {
    Sampled sampled;
    begin();
    for (Array<std::uint32_t> some = all_pieces(); !some.empty(); some = checked_.unsettled(diagram_)) {
      ++sampled.rounds;
      parts_ = checked_.check(some, diagram_.diagram(), ends_, room_);
      if (!divide(some)) break;
    }
    sampled.rounds = std::max<std::uint64_t>(sampled.rounds, 1);
    return finished(sampled);
  }

 private:
  /// From the nearer end, so that sites at equal distances from a contact are as good as that.
  Point place(const FreeEdge& edge, double t) const {
    const double x = edge.high.x - edge.low.x, y = edge.high.y - edge.low.y;
    if (t == 0) return edge.low;
    if (t == 1) return edge.high;
    if (t <= 0.5) return {in_domain_near(edge.low.x + t * x), in_domain_near(edge.low.y + t * y)};
    return {in_domain_near(edge.high.x - (1 - t) * x), in_domain_near(edge.high.y - (1 - t) * y)};
  }

  std::uint32_t add_site(const Site& site) {
    fresh_.push_back(site);
    return checked_index(sites_ + fresh_.size() - 1, "sites (points, and samples of lines and outlines)",
                         most_mesh_vertices);
  }

  std::uint32_t site_of(std::uint32_t vertex, const Point& at) {
    std::uint32_t& site = site_of_vertex_[vertex];
    if (site == none) site = add_site({at, skeleton_.object_of_vertex[vertex]});
    return site;
  }

  /// The first sites of an edge: its ends or, around contacts, one at the radius, and then at twice the distance of the
  /// one before. So the sites around a contact are alike on all edges, however small the angles.
  void add_edge(std::uint32_t e) {
    const FreeEdge& edge = skeleton_.edges[e];
    const double length = distance(edge.low, edge.high);
    Array<double>& stops = stops_;
    stops.clear();
    const auto add_shells = [&](std::uint32_t contact, bool from_high) {
      if (contact == none) return;
      double r = skeleton_.contacts[contact].radius;
      while (r <= length / 2) {
        stops_.push_back(from_high ? 1 - r / length : r / length);
        r *= 2;
      }
    };
    add_shells(edge.low_contact, false);
    const std::size_t half = stops.size();
    add_shells(edge.high_contact, true);
    std::reverse(stops.begin() + static_cast<std::ptrdiff_t>(half), stops.end());
    const bool has_contact = edge.low_contact != none || edge.high_contact != none;
    if (has_contact && stops.empty()) stops.push_back(0.5);  // Shorter than the least radius: one site all the same.
    std::uint32_t before = edge.low_contact == none ? site_of(edge.low_vertex, edge.low) : none;
    double from = 0;
    for (std::size_t i = 0; i < stops.size(); ++i) {
      if (i > 0 && !(stops[i] > stops[i - 1])) continue;
      Site site{place(edge, stops[i]), edge.object};
      if (i == 0 && half > 0) site.contact = edge.low_contact;
      if (i + 1 == stops.size() && stops.size() > half && edge.high_contact != none) site.contact = edge.high_contact;
      const std::uint32_t next = add_site(site);
      if (before != none) add_piece({e, from, stops[i]}, {before, next, edge.object});
      before = next;
      from = stops[i];
    }
    if (edge.high_contact == none) add_piece({e, from, 1}, {before, site_of(edge.high_vertex, edge.high), edge.object});
  }

  void add_piece(const Piece& piece, const PieceEnds::Ends& ends) {
    pieces_.push_back(piece);
    ends_.of_piece.push_back(ends);
  }

  /// Hands the sites over that were added since the last call. Returns the number of the first one.
  std::uint32_t make_vertices() {
    const std::uint32_t first = sites_;
    diagram_.add(fresh_);
    sites_ += static_cast<std::uint32_t>(fresh_.size());
    fresh_.clear();
    ends_.at_vertex.resize(diagram_.diagram().mesh.points.size(), {none, none});
    checked_.resize(pieces_.size());
    return first;
  }

  /// The first diagram. Until now the ends of pieces are sites.
  void begin() {
    make_vertices();
    Steps steps(pieces_.size());
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      steps();
      PieceEnds::Ends& ends = ends_.of_piece[i];
      ends.first = diagram_.vertex_of(ends.first);
      ends.last = diagram_.vertex_of(ends.last);
      note_end(ends.first, i);
      note_end(ends.last, i);
    }
  }

  Array<std::uint32_t> all_pieces() const {
    Array<std::uint32_t> all(pieces_.size());
    std::iota(all.begin(), all.end(), 0U);
    return all;
  }

  void note_end(std::uint32_t vertex, std::uint32_t piece) {
    const std::uint32_t object = ends_.of_piece[piece].object;
    if (diagram_.diagram().object[vertex] != object) return;
    auto& at = ends_.at_vertex[vertex];
    if (at[0] == piece || at[1] == piece) return;
    for (std::uint32_t& noted : at) {
      // The vertex may have had another object before.
      if (noted != none && ends_.of_piece[noted].object == object) continue;
      noted = piece;
      return;
    }
  }

  /// Divides those of `some` that are too long. False if there are none.
  bool divide(const Array<std::uint32_t>& some) {
    const auto first_part = static_cast<std::uint32_t>(pieces_.size());
    Steps steps(some.size());
    for (std::size_t k = 0; k < some.size(); ++k) {
      steps();
      if (parts_[k] == 1) continue;
      const std::uint32_t i = some[k];
      const Piece whole = pieces_[i];
      const FreeEdge& edge = skeleton_.edges[whole.edge];
      Piece part = whole;
      for (std::uint32_t n = 1; n <= parts_[k]; ++n) {
        part.to = n == parts_[k] ? whole.to : whole.from + (whole.to - whole.from) * n / parts_[k];
        if (n < parts_[k]) add_site({place(edge, part.to), edge.object});
        if (n == 1)
          pieces_[i] = part;
        else
          add_piece(part, {none, none, edge.object});
        part.from = part.to;
      }
    }
    if (fresh_.empty()) return false;
    check_count(pieces_.size(), "pieces of edges");
    const std::uint32_t first_site = make_vertices();
    give_ends(some, first_part, first_site);
    return true;
  }

  /// The ends of the parts that divide() made.
  void give_ends(const Array<std::uint32_t>& some, std::uint32_t part, std::uint32_t site) {
    Steps steps(some.size());
    for (std::size_t k = 0; k < some.size(); ++k) {
      steps();
      if (parts_[k] == 1) continue;
      const auto [first, last, object] = ends_.of_piece[some[k]];
      for (std::uint32_t n = 1, i = some[k]; n < parts_[k]; ++n) {
        const std::uint32_t v = diagram_.vertex_of(site++);
        ends_.of_piece[i].last = v;
        ends_.of_piece[part] = {v, last, object};
        note_end(v, i);
        note_end(v, part);
        i = part++;
      }
      for (std::uint32_t& at : ends_.at_vertex[last])
        if (at == some[k]) at = part - 1;
    }
  }

  Sampled finished(Sampled sampled) {
    for (const Contact& contact : skeleton_.contacts) sampled.error = std::max(sampled.error, contact.radius);
    sampled.narrow.assign(skeleton_.edges.size(), false);
    for (std::uint32_t e = 0; e < skeleton_.edges.size(); ++e)
      sampled.narrow[e] = skeleton_.edges[e].low_contact != none || skeleton_.edges[e].high_contact != none;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      sampled.error = std::max(sampled.error, checked_.error(i));
      if (checked_.is_narrow(i)) sampled.narrow[pieces_[i].edge] = true;
    }
    sampled.sites = sites_ - room_.ring.size();
    sampled.diagram = diagram_.take();
    return sampled;
  }

  const Skeleton& skeleton_;
  const Room& room_;
  GrowingDiagram diagram_;
  LargeArray<Site> fresh_;   ///< sites that have no vertex yet
  std::uint32_t sites_ = 0;  ///< those that have one
  LargeArray<Piece> pieces_;
  PieceEnds ends_;
  CheckedPieces checked_;
  Array<std::uint32_t> parts_;  ///< by place in the list of pieces that were checked last
  Array<std::uint32_t> site_of_vertex_;
  Array<double> stops_;
};

}  // namespace

Sampled sample(const Skeleton& skeleton, const Room& room) { return Sampling(skeleton, room).run(); }

}  // namespace oblast::internal::zoning
