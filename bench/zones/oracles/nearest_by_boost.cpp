// The nearest site by Boost.Polygon's Voronoi diagram of points and segments. Arguments as in sites.h.
//
// A place is found by a walk from cell to cell. If the place is not in the cell of s, the way to it from the nearest
// place of s leaves that cell, through an edge that is as near to another site t. So t is nearer to the place than s,
// or as near if the way leaves at once: at an end of s that it shares with t. So the walk also goes on to sites that
// are as near. Only neighbours in the diagram are asked, so a wrong diagram gives a wrong answer.
#include <algorithm>
#include <boost/polygon/polygon.hpp>
#include <boost/polygon/voronoi.hpp>
#include <optional>

#include "zones/oracles/sites.h"

namespace {

namespace polygon = boost::polygon;
using zones::Site, zones::Xy;
using Diagram = polygon::voronoi_diagram<double>;
using Cell = Diagram::cell_type;

using Real = long double;

Real squared_distance(const Xy& p, const Site& s) {
  const Real dx = Real(s.x1) - s.x0, dy = Real(s.y1) - s.y0;
  const auto from = [&](Real x, Real y) { return (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y); };
  const Real along = (p.x - s.x0) * dx + (p.y - s.y0) * dy, length = dx * dx + dy * dy;
  if (along <= 0) return from(s.x0, s.y0);
  if (along >= length) return from(s.x1, s.y1);
  const Real across = (p.x - s.x0) * dy - (p.y - s.y0) * dx;
  return across * across / length;
}

class Oracle {
 public:
  explicit Oracle(const zones::Sites& sites) : sites_(sites) {
    std::vector<polygon::point_data<std::int32_t>> points;
    std::vector<polygon::segment_data<std::int32_t>> segments;
    for (const Site& s : sites.points) points.emplace_back(s.x0, s.y0);
    for (const Site& s : sites.segments)
      segments.push_back({polygon::point_data<std::int32_t>(s.x0, s.y0), {s.x1, s.y1}});
    polygon::construct_voronoi(points.begin(), points.end(), segments.begin(), segments.end(), &diagram_);
    cell_ = &diagram_.cells().front();
  }

  Site nearest(const Xy& p) {
    std::vector<const Cell*> as_near{cell_};  // each of them once
    Real least = squared_distance(p, site(*cell_));
    for (std::size_t k = 0; k < as_near.size(); ++k) {
      const auto* const first = as_near[k]->incident_edge();
      if (!first) continue;  // the only site
      for (const auto* edge = first;;) {
        const Cell* const other = edge->twin()->cell();
        const Real found = squared_distance(p, site(*other));
        if (found < least) {
          least = found;
          cell_ = other;
          as_near = {other};
          k = std::size_t(-1);
          break;
        }
        if (found <= least * (1 + Real(1e-15)) && std::find(as_near.begin(), as_near.end(), other) == as_near.end())
          as_near.push_back(other);
        edge = edge->next();
        if (edge == first) break;
      }
    }
    return site(*cell_);
  }

 private:
  Site site(const Cell& cell) const {
    if (cell.source_category() == polygon::SOURCE_CATEGORY_SINGLE_POINT) return sites_.points[cell.source_index()];
    const Site& s = sites_.segments[cell.source_index() - sites_.points.size()];
    if (cell.contains_segment()) return s;
    const bool is_start = cell.source_category() == polygon::SOURCE_CATEGORY_SEGMENT_START_POINT;
    return is_start ? Site{s.x0, s.y0, s.x0, s.y0} : Site{s.x1, s.y1, s.x1, s.y1};
  }

  const zones::Sites& sites_;
  Diagram diagram_;
  const Cell* cell_;
};

}  // namespace

int main(int argc, char** argv) {
  std::optional<Oracle> oracle;
  return zones::answer(argc, argv, [&](const zones::Sites& sites) {
    oracle.emplace(sites);
    return [&](const Xy& p) { return oracle->nearest(p); };
  });
}
