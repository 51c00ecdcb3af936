// Boost.Geometry: the polygons whose boxes hold the point, from a tree that is packed at once; then `within` each. (Of
// the whole multipolygon `within` would look at every edge.)
#include "locate/with_boost.h"

#include <boost/version.hpp>

#include "locate/contestant.h"

namespace oblast::bench {
namespace {

class WithBoost : public Contestant {
 public:
  std::string name() const override { return "Boost " BOOST_LIB_VERSION ", rtree of polygons, within"; }
  std::string library() const override { return "Boost"; }
  void load(const RegionView& regions) override { polygons_ = boost_polygons(regions); }
  void build() override { tree_ = tree_of(polygons_); }
  void ask(std::span<const Point> points, std::span<std::uint8_t> inside) override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const BoostPoint p(points[i].x, points[i].y);
      inside[i] = is_in_any(tree_, p, [&](std::uint32_t polygon) { return bg::within(p, polygons_[polygon]); });
    }
  }

 private:
  std::vector<BoostPolygon> polygons_;
  PolygonTree tree_;
};

}  // namespace

std::vector<std::unique_ptr<Contestant>> boost_contestants() {
  std::vector<std::unique_ptr<Contestant>> result;
  result.push_back(std::make_unique<WithBoost>());
  return result;
}

}  // namespace oblast::bench
