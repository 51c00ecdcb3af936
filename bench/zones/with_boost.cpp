// Boost.Polygon's Voronoi diagram. It wants 32-bit integers, so points are scaled to them and rounded, and cells are
// scaled back. Arguments as in shape_file.h, of which distance and segments are not used.
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <cstdint>

#include "zones/cells.h"

namespace {

namespace polygon = boost::polygon;
using Site = polygon::point_data<std::int32_t>;

class Scale {
 public:
  explicit Scale(const zones::Frame& frame)
      : x_((frame.x0 + frame.x1) / 2),
        y_((frame.y0 + frame.y1) / 2),
        // The points far away must fit, too.
        factor_(2e9 / (9 * std::max(frame.x1 - frame.x0, frame.y1 - frame.y0))) {}
  Site to(const buffers::Xy& p) const {
    return {static_cast<std::int32_t>(std::lround((p.x - x_) * factor_)),
            static_cast<std::int32_t>(std::lround((p.y - y_) * factor_))};
  }
  buffers::Xy back(double x, double y) const { return {x_ + x / factor_, y_ + y / factor_}; }

 private:
  double x_, y_, factor_;
};

buffers::Shapes cells_of(const std::vector<buffers::Xy>& points) {
  const zones::Frame frame(points);
  const Scale scale(frame);
  std::vector<Site> sites;
  sites.reserve(points.size() + 4);
  for (const auto& p : points) sites.push_back(scale.to(p));
  for (const auto& p : frame.far_away()) sites.push_back(scale.to(p));
  polygon::voronoi_diagram<double> diagram;
  polygon::construct_voronoi(sites.begin(), sites.end(), &diagram);
  buffers::Shapes cells;
  std::vector<buffers::Xy> ring;
  for (const auto& cell : diagram.cells()) {
    if (cell.is_degenerate() || cell.source_index() >= points.size()) continue;
    ring.clear();
    const auto* const first = cell.incident_edge();
    const auto* edge = first;
    do {
      if (edge->vertex0()) ring.push_back(scale.back(edge->vertex0()->x(), edge->vertex0()->y()));
      edge = edge->next();
    } while (edge != first);
    zones::add_cell(ring, frame, cells);
  }
  return cells;
}

}  // namespace

int main(int argc, char** argv) { return zones::drive(argc, argv, cells_of); }
