#include "oblast/fault_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/formats.h"
#include "oblast/console.h"
#include "oblast/no_polygons.h"

namespace oblast::app {

namespace {

constexpr std::size_t listed = 20;

FeatureFaultKind kind_at(std::size_t i) { return static_cast<FeatureFaultKind>(i); }

}  // namespace

FaultReport::FaultReport(const io::Layer& layer, const FeatureView& features, std::vector<FeatureFault> faults)
    : layer_(layer), features_(features), faults_(std::move(faults)) {}

bool FaultReport::has_faults() const {
  return std::any_of(faults_.begin(), faults_.end(), [](const FeatureFault& f) { return !is_note(f.kind); });
}

FaultReport::Words FaultReport::words(const FeaturePlace& place) const {
  Words words;
  if (place.feature == FeaturePlace::none) return words;
  const io::FeatureRange& range = layer_.features[place.feature];
  words.file = layer_.files[range.file];
  words.feature = range.feature;
  if (place.contour == FeaturePlace::none) return words;
  const RegionView& regions = features_.regions;
  const auto polygon = static_cast<std::uint32_t>(
      std::upper_bound(regions.polygon_ends.begin(), regions.polygon_ends.end(), place.contour) -
      regions.polygon_ends.begin());
  words.part = polygon - features_.feature_begin(place.feature) + 1;
  words.ring = place.contour - regions.polygon_begin(polygon) + 1;
  if (place.vertex == FeaturePlace::none) return words;
  words.vertex = place.vertex;
  // Rings of shapefiles are reversed on reading, and keep their first vertex.
  if (place.vertex > 0 && io::lower_extension(words.file) == ".shp")
    words.vertex = static_cast<std::int64_t>(regions.contour(place.contour).size()) - place.vertex;
  return words;
}

std::string FaultReport::text(const FeaturePlace& place) const {
  const Words w = words(place);
  std::string text = layer_.files.size() > 1 ? w.file + ", " : "";
  text += fmt::format("feature {}", w.feature);
  if (w.ring >= 0) text += fmt::format(", part {}, ring {}", w.part, w.ring);
  if (w.vertex >= 0) text += fmt::format(", vertex {}", w.vertex);
  return text;
}

std::string FaultReport::text(const FeatureFault& fault) const {
  std::string text = fmt::format("  {} at ({} {})", name(fault.kind), fault.point.x, fault.point.y);
  if (fault.kind == FeatureFaultKind::overlap || fault.kind == FeatureFaultKind::gap)
    text += fmt::format(", area {:.6g}", fault.area);
  if (fault.place.feature != FeaturePlace::none) text += "\n    " + this->text(fault.place);
  if (fault.other.feature != FeaturePlace::none) text += "\n    " + this->text(fault.other);
  return text + "\n";
}

std::vector<FaultReport::Counts> FaultReport::count() const {
  std::vector<Counts> counts(feature_fault_kinds);
  std::vector<std::vector<std::uint32_t>> features(feature_fault_kinds);
  for (const FeatureFault& fault : faults_) {
    const auto kind = static_cast<std::size_t>(fault.kind);
    ++counts[kind].faults;
    for (const FeaturePlace& place : {fault.place, fault.other})
      if (place.feature != FeaturePlace::none) features[kind].push_back(place.feature);
  }
  for (std::size_t i = 0; i < feature_fault_kinds; ++i) {
    std::sort(features[i].begin(), features[i].end());
    counts[i].features =
        static_cast<std::size_t>(std::unique(features[i].begin(), features[i].end()) - features[i].begin());
  }
  return counts;
}

std::string FaultReport::to_text(bool coverage) const {
  const std::vector<Counts> counts = count();
  std::size_t faults = 0, notes = 0;
  for (std::size_t i = 0; i < feature_fault_kinds; ++i) (is_note(kind_at(i)) ? notes : faults) += counts[i].faults;
  const RegionView& regions = features_.regions;
  const std::string size = fmt::format(
      "{}, {}, {}, {}", counted(features_.feature_count(), "feature"), counted(regions.polygon_count(), "part"),
      counted(regions.contour_count(), "ring"), counted(regions.points.size(), "vertex"));
  std::string text = faults == 0 ? fmt::format("{}: {}\n", coverage ? "valid coverage" : "valid", size)
                                 : fmt::format("{} in {}\n", counted(faults, "fault"), size);
  for (std::size_t i = 0; i < feature_fault_kinds; ++i)
    if (counts[i].faults > 0)
      text +=
          fmt::format("  {:<30}{:>12}  in {}\n", std::string(name(kind_at(i))) + (is_note(kind_at(i)) ? " (note)" : ""),
                      grouped(counts[i].faults), counted(counts[i].features, "feature"));
  const std::string others = lines_and_points(layer_.report);
  if (!others.empty()) text += fmt::format("not checked: {}\n", others);
  if (faults == 0) return text;
  text += faults > listed ? fmt::format("the first {} of {} faults:\n", listed, grouped(faults)) : "faults:\n";
  std::size_t shown = 0;
  for (const FeatureFault& fault : faults_)
    if (!is_note(fault.kind) && shown++ < listed) text += this->text(fault);
  return text;
}

nlohmann::ordered_json FaultReport::json(const FeaturePlace& place) const {
  const Words w = words(place);
  if (w.feature < 0 && w.file.empty()) return nullptr;
  nlohmann::ordered_json object;
  if (layer_.files.size() > 1) object["file"] = w.file;
  object["feature"] = w.feature;
  if (w.ring >= 0) object["part"] = w.part, object["ring"] = w.ring;
  if (w.vertex >= 0) object["vertex"] = w.vertex;
  return object;
}

nlohmann::ordered_json FaultReport::to_json(const std::string& file, bool coverage) const {
  const RegionView& regions = features_.regions;
  nlohmann::ordered_json object{{"file", file},
                                {"checked", coverage ? "coverage" : "features"},
                                {"valid", !has_faults()},
                                {"features", features_.feature_count()},
                                {"parts", regions.polygon_count()},
                                {"rings", regions.contour_count()},
                                {"vertices", regions.points.size()}};
  const std::vector<Counts> counts = count();
  auto kinds = nlohmann::ordered_json::object(), notes = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < feature_fault_kinds; ++i)
    if (counts[i].faults > 0) (is_note(kind_at(i)) ? notes : kinds)[name(kind_at(i))] = counts[i].faults;
  object["faults_by_kind"] = std::move(kinds);
  object["notes_by_kind"] = std::move(notes);
  auto list = nlohmann::ordered_json::array();
  for (const FeatureFault& fault : faults_) {
    nlohmann::ordered_json item{{"kind", name(fault.kind)},
                                {"note", is_note(fault.kind)},
                                {"at", {fault.point.x, fault.point.y}},
                                {"place", json(fault.place)},
                                {"other", json(fault.other)}};
    if (fault.kind == FeatureFaultKind::overlap || fault.kind == FeatureFaultKind::gap) item["area"] = fault.area;
    list.push_back(std::move(item));
  }
  object["faults"] = std::move(list);
  return object;
}

std::vector<io::PlaceColumn> FaultReport::columns() const {
  std::vector<std::string> kinds, files, other_files;
  std::vector<double> areas;
  std::vector<std::int64_t> numbers[8];
  for (const FeatureFault& fault : faults_) {
    const Words a = words(fault.place), b = words(fault.other);
    kinds.emplace_back(name(fault.kind));
    areas.push_back(fault.area);
    files.push_back(a.file);
    const std::int64_t values[] = {a.feature, a.part, a.ring, a.vertex, b.feature, b.part, b.ring, b.vertex};
    for (std::size_t i = 0; i < 8; ++i) numbers[i].push_back(values[i]);
    other_files.push_back(b.file);
  }
  constexpr const char* names[] = {"feature", "part", "ring", "vertex", "feature_2", "part_2", "ring_2", "vertex_2"};
  std::vector<io::PlaceColumn> columns{{"kind", std::move(kinds)}};
  for (std::size_t i = 0; i < 8; ++i) columns.push_back({names[i], std::move(numbers[i])});
  columns.push_back({"area", std::move(areas)});
  if (layer_.files.size() > 1) {
    columns.push_back({"file", std::move(files)});
    columns.push_back({"file_2", std::move(other_files)});
  }
  return columns;
}

}  // namespace oblast::app
