// Layers with rows: which field lies in which district, and how much of each is in none.
#include <oblast/oblast.h>

#include <cstdio>

namespace {

void add_square(oblast::RegionBuilder& layer, double x, double y, double side) {
  layer.add_polygon(std::array<oblast::Point, 4>{{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}});
}

}  // namespace

int main() {
  oblast::RegionBuilder builder;
  for (const double x : {0.0, 3.0, 6.0}) add_square(builder, x, 1, 3);  // three fields, side by side
  const oblast::RegionSet fields = builder.take();
  for (const double x : {0.0, 4.0}) add_square(builder, x, 0, 4);  // two districts
  const oblast::RegionSet districts = builder.take();

  // Every polygon is a row here; feature_ends would put several polygons into one row.
  const oblast::FeatureView a{fields, {}}, b{districts, {}};
  const oblast::FeatureSet rows = oblast::overlay_features(a, b, oblast::FeatureOperation::identity);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    double area = 0;
    for (std::uint32_t p = oblast::FeatureView(rows).feature_begin(row); p < rows.feature_ends[row]; ++p)
      area += oblast::area(rows.regions.polygon(p));
    const auto [field, district] = rows.keys[row];
    if (district == oblast::no_feature)
      std::printf("field %u in no district: %g\n", field, area);
    else
      std::printf("field %u in district %u: %g\n", field, district, area);
  }
}
