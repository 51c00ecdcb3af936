// The fires of `oblast generate fires`.
#include "golden/inputs.h"
#include "golden/results.h"
#include "oblast/fires.h"

namespace oblast::golden {
namespace {

RegionSet all_passes(const app::FiresOptions& options) {
  RegionSet all;
  for (const app::FirePass& pass : app::generate_fires(options)) {
    const auto points = static_cast<std::uint32_t>(all.points.size());
    const auto contours = static_cast<std::uint32_t>(all.contour_ends.size());
    all.points.insert(all.points.end(), pass.contours.points.begin(), pass.contours.points.end());
    for (const std::uint32_t end : pass.contours.contour_ends) all.contour_ends.push_back(points + end);
    for (const std::uint32_t end : pass.contours.polygon_ends) all.polygon_ends.push_back(contours + end);
  }
  return all;
}

}  // namespace

Family fires() {
  Family family{
      "fires", "the fires: unions of each month and of all, and a twentieth of them under several rules", false, {}};
  for (const app::FireMonth& month : app::fire_months) {
    family.inputs.push_back({"month " + std::to_string(month.month), [&month] {
                               app::FiresOptions options;
                               options.months = {month.month};
                               return unions(all_passes(options), {FillRule::polygons()});
                             }});
  }
  family.inputs.push_back({"all", [] { return unions(all_passes({}), {FillRule::polygons()}); }});
  app::FiresOptions twentieth;
  twentieth.scale = 0.05;
  family.inputs.push_back({"twentieth, several rules", [twentieth] {
                             return unions(all_passes(twentieth),
                                           {FillRule::polygons(), FillRule::at_least(2), FillRule::even_odd(),
                                            FillRule::nonzero(), FillRule::positive(), FillRule::negative()});
                           }});
  family.inputs.push_back({"twentieth, hull, layers, triangulation",
                           [twentieth] { return hull_layers_triangulation(all_passes(twentieth)); }});
  return family;
}

}  // namespace oblast::golden
