#include "verify/rows.h"

#include <algorithm>

#include "verify/edges.h"
#include "verify/planar.h"
#include "verify/slabs.h"
#include "verify/sources.h"
#include "verify/wrong_places.h"

namespace oblast::verify {
namespace {

std::optional<Fault> check_feature_ends(const FeatureView& rows) {
  std::uint32_t before = 0;
  for (const std::uint32_t end : rows.feature_ends) {
    if (end < before) return Fault{"feature_ends decrease", {}};
    before = end;
  }
  if (!rows.feature_ends.empty() && before != rows.regions.polygon_count())
    return Fault{"the last of feature_ends is not the number of polygons", {}};
  return std::nullopt;
}

std::optional<Fault> check_each(const FeatureView& rows, ContourConvention convention) {
  for (std::size_t f = 0; f < rows.feature_count(); ++f) {
    if (rows.feature_begin(f) == rows.feature_end(f)) continue;
    auto fault = check_result(regions_of(rows, f), convention);
    if (!fault) continue;
    const std::uint32_t first = rows.feature_begin(f);
    if (fault->place.polygon != Place::npos) fault->place.polygon += first;
    if (fault->place.contour != Place::npos) fault->place.contour += rows.regions.polygon_begin(first);
    fault->what = "row " + std::to_string(f) + ": " + fault->what;
    return fault;
  }
  return std::nullopt;
}

std::optional<Fault> check_together(const FeatureView& rows) {
  const Edges edges(rows.regions);
  std::vector<PlainEdge> plain;
  plain.reserve(edges.size());
  for (std::uint32_t e = 0; e < edges.size(); ++e) plain.push_back({edges.left_end(e), edges.right_end(e), e});
  std::sort(plain.begin(), plain.end(), [](const PlainEdge& e, const PlainEdge& f) {
    if (e.left != f.left) return lexicographically_less(e.left, f.left);
    return e.right != f.right ? lexicographically_less(e.right, f.right) : e.vertex < f.vertex;
  });
  plain.erase(std::unique(plain.begin(), plain.end()), plain.end());
  const auto bad = find_bad_meeting(plain);
  if (!bad) return std::nullopt;
  const auto name = [](const PlainEdge& e) { return to_text(e.left) + " - " + to_text(e.right); };
  return edges.fault_at(bad->second.vertex, "edge " + name(bad->second) + " crosses, touches or overlaps edge " +
                                                name(bad->first) +
                                                " of another row elsewhere than at a common end point");
}

}  // namespace

RegionView regions_of(const FeatureView& layer, std::size_t feature) {
  const RegionView& all = layer.regions;
  const std::uint32_t begin = layer.feature_begin(feature), end = layer.feature_end(feature);
  if (begin == end) return {};
  RegionView regions = all.contours_between(all.polygon_begin(begin), all.polygon_end(end - 1));
  if (!all.polygon_ends.empty()) {
    regions.polygon_ends = all.polygon_ends.subspan(begin, end - begin);
    regions.first_contour = all.first_contour + all.polygon_begin(begin);
  }
  return regions;
}

std::optional<Fault> check_rows(const FeatureView& rows, ContourConvention convention) {
  if (auto fault = check_feature_ends(rows)) return fault;
  if (auto fault = check_each(rows, convention)) return fault;
  return check_together(rows);
}

std::vector<FeatureKey> keys_of_place(FeatureOperation operation, const std::vector<std::uint32_t>& i,
                                      const std::vector<std::uint32_t>& j) {
  using enum FeatureOperation;
  std::vector<FeatureKey> keys;
  if (operation == intersection || operation == identity || operation == unite)
    for (const std::uint32_t a : i)
      for (const std::uint32_t b : j) keys.push_back({a, b});
  if (operation != intersection && j.empty())
    for (const std::uint32_t a : i) keys.push_back({a, no_feature});
  if ((operation == unite || operation == symmetric_difference) && i.empty())
    for (const std::uint32_t b : j) keys.push_back({no_feature, b});
  std::sort(keys.begin(), keys.end());
  return keys;
}

std::optional<Fault> check_rows_against(const FeatureView& a, const FeatureView& b, const KeysOfPlace& keys,
                                        const FeatureView& rows, const std::vector<FeatureKey>& row_keys,
                                        double bound_ulps) {
  const Sources sources(a.regions, b.regions, Options{}, bound_ulps);
  std::vector<Operand> operands;
  const auto add = [&](const FeatureView& layer, const FillRule& rule) {
    for (std::size_t f = 0; f < layer.feature_count(); ++f) operands.push_back({regions_of(layer, f), rule});
  };
  add(a, FillRule::polygons());
  add(b, FillRule::polygons());
  add(rows, FillRule::even_odd());
  const auto present = [](const std::vector<bool>& inside, std::size_t first, std::size_t count) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t f = 0; f < count; ++f)
      if (inside[first + f]) found.push_back(f);
    return found;
  };
  const auto for_each_wrong = [&](const auto& visit) {
    for_each_trapezoid(operands, [&](const Trapezoid& t) {
      const auto i = present(t.inside, 0, a.feature_count());
      const auto j = present(t.inside, a.feature_count(), b.feature_count());
      std::vector<FeatureKey> here;
      for (const std::uint32_t row : present(t.inside, a.feature_count() + b.feature_count(), rows.feature_count()))
        here.push_back(row_keys[row]);
      if (here != keys(i, j)) visit(t);
    });
  };
  return judge_wrong_places(for_each_wrong, sources, "the rows are not what their keys say",
                            "the places where rows are wrong are larger than their edges may have moved");
}

}  // namespace oblast::verify
