#include "zones/sampling.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "zones/distance.h"
#include "zones/piece_check.h"

namespace oblast::internal::zoning {
namespace {

/// A part of an edge between two sites.
struct Piece {
  std::uint32_t edge;
  std::uint32_t first, last;  ///< sites
  double from, to;            ///< along the edge, from 0 to 1
};

class Sampling {
 public:
  Sampling(const Skeleton& skeleton, const Room& room) : skeleton_(skeleton), room_(room) {
    for (const Point& p : room.ring) sites_.push_back({p, none});
    for (const LonePoint& point : skeleton.points) sites_.push_back({point.at, point.object});
    site_of_vertex_.resize(skeleton.object_of_vertex.size(), none);
    for (std::uint32_t e = 0; e < skeleton.edges.size(); ++e) add_edge(e);
    site_of_vertex_ = {};
  }

  Sampled run() {
    Sampled sampled;
    for (const Contact& contact : skeleton_.contacts) sampled.error = std::max(sampled.error, contact.radius);
    double error = 0;
    for (bool divided = true; divided;) {
      ++sampled.rounds;
      sampled.diagram = {};
      sampled.diagram = make_diagram(sites_, skeleton_.contacts);
      divided = divide(sampled.diagram, error);
    }
    sampled.error = std::max(sampled.error, error);
    sampled.narrow.assign(skeleton_.edges.size(), false);
    for (std::uint32_t e = 0; e < skeleton_.edges.size(); ++e)
      sampled.narrow[e] = skeleton_.edges[e].low_contact != none || skeleton_.edges[e].high_contact != none;
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      if (narrow_[i]) sampled.narrow[pieces_[i].edge] = true;
    sampled.sites = sites_.size() - room_.ring.size();
    return sampled;
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
    sites_.push_back(site);
    return static_cast<std::uint32_t>(sites_.size() - 1);
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
      if (before != none) pieces_.push_back({e, before, next, from, stops[i]});
      before = next;
      from = stops[i];
    }
    if (edge.high_contact == none) pieces_.push_back({e, before, site_of(edge.high_vertex, edge.high), from, 1});
  }

  /// False if all pieces are short enough. `error`: the largest epsilon that those need.
  bool divide(const Diagram& diagram, double& error) {
    const PieceEnds ends = ends_in(diagram);
    Array<std::uint8_t> halvings(pieces_.size());
    narrow_.assign(pieces_.size(), 0);
    Array<double> errors(range_count(pieces_.size(), tuning::checked_pieces_a_range), 0);
    for_numbered_ranges(
        pieces_.size(), tuning::checked_pieces_a_range, [&](std::size_t range, std::size_t i, std::size_t end) {
          PieceCheck check(diagram, ends, room_);
          for (; i < end; ++i) {
            const auto [first, last] = ends.of_piece[i];
            halvings[i] =
                static_cast<std::uint8_t>(check.halvings(first, last, skeleton_.edges[pieces_[i].edge].object));
            narrow_[i] = check.is_narrow();
          }
          errors[range] = check.error();
        });
    error = 0;
    for (const double e : errors) error = std::max(error, e);
    return halve(halvings);
  }

  PieceEnds ends_in(const Diagram& diagram) const {
    const Mesh& mesh = diagram.mesh;
    PieceEnds ends;
    ends.leaving.resize(mesh.points.size(), none);
    Steps steps(mesh.triangles.size() + pieces_.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      steps();
      for (std::uint32_t i = 0; i < 3; ++i)
        if (const std::uint32_t v = mesh.triangles[t].vertex[i]; v != triangulation::infinite_vertex)
          ends.leaving[v] = triangulation::half_edge(t, i);
    }
    ends.of_piece.reserve(pieces_.size());
    ends.at_vertex.resize(mesh.points.size(), {none, none});
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      steps();
      ends.of_piece.push_back({mesh.vertex_of[pieces_[i].first], mesh.vertex_of[pieces_[i].last]});
      for (const std::uint32_t v : {ends.of_piece[i].first, ends.of_piece[i].last}) {
        if (diagram.object[v] != skeleton_.edges[pieces_[i].edge].object) continue;
        auto& at = ends.at_vertex[v];
        if (at[0] == none)
          at[0] = i;
        else if (at[1] == none)
          at[1] = i;
      }
    }
    return ends;
  }

  bool halve(const Array<std::uint8_t>& halvings) {
    LargeArray<Piece> pieces;
    Steps steps(pieces_.size());
    bool divided = false;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      steps();
      const Piece whole = pieces_[i];
      const int parts = 1 << halvings[i];
      divided |= parts > 1;
      const FreeEdge& edge = skeleton_.edges[whole.edge];
      Piece piece = whole;
      for (int k = 1; k <= parts; ++k) {
        piece.to = k == parts ? whole.to : whole.from + (whole.to - whole.from) * k / parts;
        piece.last = k == parts ? whole.last : add_site({place(edge, piece.to), edge.object});
        pieces.push_back(piece);
        piece.from = piece.to;
        piece.first = piece.last;
      }
    }
    check_count(sites_.size(), "sites (points, and samples of lines and outlines)", most_mesh_vertices);
    pieces_ = std::move(pieces);
    return divided;
  }

  const Skeleton& skeleton_;
  const Room& room_;
  LargeArray<Site> sites_;
  LargeArray<Piece> pieces_;
  Array<std::uint8_t> narrow_;  ///< by piece
  Array<std::uint32_t> site_of_vertex_;
  Array<double> stops_;
};

}  // namespace

Sampled sample(const Skeleton& skeleton, const Room& room) { return Sampling(skeleton, room).run(); }

}  // namespace oblast::internal::zoning
