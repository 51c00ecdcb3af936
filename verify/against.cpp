// Checks whether a result is right, by recomputation with exact rationals.
#include "verify/against.h"

#include <algorithm>
#include <cmath>

#include "verify/edges.h"
#include "verify/predicates.h"
#include "verify/slabs.h"
#include "verify/sources.h"
#include "verify/wrong_places.h"

namespace oblast::verify {
namespace {

class Comparison {
 public:
  Comparison(const Sources& sources, const Edges& edges, const Options& options)
      : sources_(sources), edges_(edges), options_(options) {}

  std::optional<Fault> check_vertices(Provenance& provenance) const {
    for (std::uint32_t v = 0; v < edges_.size(); ++v) {
      const Point& p = edges_.from(v);
      provenance.largest_displacement_ulps =
          std::max(provenance.largest_displacement_ulps, sources_.displacement_ulps(p));
      if (sources_.is_vertex(p)) {
        ++provenance.input_vertices;
      } else if (sources_.is_rounded_intersection(p)) {
        ++provenance.intersections;
      } else if (sources_.near_both(p, p).size() >= 2) {
        ++provenance.later_rounds;
      } else {
        return edges_.fault_at(v, to_text(p) + " is neither an input vertex nor close to where two input edges meet");
      }
    }
    return std::nullopt;
  }

  std::optional<Fault> check_edges() const {
    if (options_.collinear == CollinearVertices::drop) return std::nullopt;
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      if (sources_.near_both(edges_.from(e), edges_.to(e)).empty()) {
        return edges_.fault_at(e, "edge " + name(e) + " does not lie along any input edge");
      }
    }
    return std::nullopt;
  }

  // Checks the collinear vertices that must be in the result (`keep`) or must not be there (`drop`).
  std::optional<Fault> check_collinear(const RegionView& a, const RegionView& b) const {
    if (options_.collinear == CollinearVertices::drop) return check_minimal();
    for (const RegionView& operand : {a, b}) {
      for (const Point& p : operand.points) {
        for (std::uint32_t e = 0; e < edges_.size(); ++e) {
          if (!lies_inside(p, e) || sources_.may_have_cancelled(p)) continue;
          if (sources_.may_have_moved_onto(p, edges_.from(e), edges_.to(e))) continue;
          return edges_.fault_at(e, "input vertex " + to_text(p) + " was left out of edge " + name(e));
        }
      }
    }
    return std::nullopt;
  }

  // A vertex that is not an input vertex and joins two pieces of one input edge is allowed only if the result would not
  // be closed without it.
  std::optional<Fault> check_traces() const {
    if (options_.collinear == CollinearVertices::drop) return std::nullopt;
    for (std::uint32_t u = 0; u < edges_.size(); ++u) {
      const std::uint32_t v = edges_.next[u];
      const Point &before = edges_.from(u), &at = edges_.from(v), &after = edges_.to(v);
      if (sources_.is_vertex(at) || is_touched(v) || sources_.may_be_resolved(at)) continue;
      const auto source = sources_.near_both(before, at);
      if (source.size() != 1 || sources_.near_both(at, after) != source) continue;
      if (closed_without(v)) {
        return edges_.fault_at(v, "vertex " + to_text(at) + " is a trace: both its edges are pieces of one input edge");
      }
    }
    return std::nullopt;
  }

 private:
  std::string name(std::uint32_t e) const { return to_text(edges_.from(e)) + " -> " + to_text(edges_.to(e)); }

  bool lies_inside(const Point& p, std::uint32_t e) const {
    const Point &from = edges_.from(e), &to = edges_.to(e);
    if (p == from || p == to) return false;
    if (p.x < std::min(from.x, to.x) || p.x > std::max(from.x, to.x)) return false;
    if (p.y < std::min(from.y, to.y) || p.y > std::max(from.y, to.y)) return false;
    return side_of_line(from, to, p) == 0;
  }

  // True if another pass of any contour goes through vertex v.
  bool is_touched(std::uint32_t v) const {
    const auto& points = edges_.regions.points;
    return std::count(points.begin(), points.end(), edges_.from(v)) > 1;
  }

  std::optional<Fault> check_minimal() const {
    for (std::uint32_t u = 0; u < edges_.size(); ++u) {
      const std::uint32_t v = edges_.next[u];
      if (is_touched(v) || side_of_line(edges_.from(u), edges_.from(v), edges_.to(v)) != 0) continue;
      return edges_.fault_at(v, "vertex " + to_text(edges_.from(v)) + " lies exactly between its neighbours");
    }
    return std::nullopt;
  }

  bool closed_without(std::uint32_t v) const {
    RegionSet shorter;
    const RegionView& all = edges_.regions;
    shorter.points.assign(all.points.begin(), all.points.end());
    shorter.points.erase(shorter.points.begin() + v);
    shorter.contour_ends.assign(all.contour_ends.begin(), all.contour_ends.end());
    for (std::uint32_t& end : shorter.contour_ends) end -= all.first_point;
    for (std::size_t c = edges_.contour_of[v]; c < shorter.contour_ends.size(); ++c) --shorter.contour_ends[c];
    shorter.polygon_ends.assign(all.polygon_ends.begin(), all.polygon_ends.end());
    for (std::uint32_t& end : shorter.polygon_ends) end -= all.first_contour;
    return !check_closed(shorter, options_.contours);
  }

  const Sources& sources_;
  const Edges& edges_;
  const Options& options_;
};

std::optional<Fault> check_regions(const RegionView& a, const RegionView& b, Operation operation,
                                   const Options& options, const RegionView& result, const Sources& sources) {
  const std::vector<Operand> operands{{a, options.fill_a}, {b, options.fill_b}, {result, FillRule::even_odd()}};
  const auto for_each_wrong = [&](const auto& visit) {
    for_each_trapezoid(operands, [&](const Trapezoid& t) {
      if (selects(operation, t.inside[0], t.inside[1]) != t.inside[2]) visit(t);
    });
  };
  return judge_wrong_places(for_each_wrong, sources, "the result is not what the operation says",
                            "the places where the result is wrong are larger than its edges may have moved");
}

}  // namespace

std::optional<Fault> check_against(const RegionView& a, const RegionView& b, Operation operation,
                                   const Options& options, const RegionView& result, double bound_ulps,
                                   Provenance* provenance) {
  const Sources sources(a, b, options, bound_ulps);
  const Edges edges(result);
  const Comparison comparison(sources, edges, options);
  Provenance counted;
  if (auto fault = comparison.check_vertices(provenance != nullptr ? *provenance : counted)) return fault;
  if (auto fault = comparison.check_edges()) return fault;
  if (auto fault = check_regions(a, b, operation, options, result, sources)) return fault;
  if (auto fault = comparison.check_collinear(a, b)) return fault;
  return comparison.check_traces();
}

}  // namespace oblast::verify
