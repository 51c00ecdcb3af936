#include "oblast/repair_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "oblast/console.h"

namespace oblast::app {

namespace {

using Json = nlohmann::ordered_json;

/// Lines of changes in the text; JSON has all of them.
constexpr std::size_t most_lines = 20;

const char* word(CoverageChange change) {
  constexpr const char* words[] = {"overlap", "gap", "sliver"};
  return words[static_cast<int>(change)];
}

std::string text(const Point& p) { return fmt::format("({} {})", p.x, p.y); }

}  // namespace

std::string RepairReport::name(std::uint32_t row) const {
  const io::FeatureRange& feature = layer_.layer.features[row];
  const std::string file = layer_.layer.files.size() > 1 ? layer_.layer.files[feature.file] + ", " : "";
  return fmt::format("{}feature {}", file, feature.feature);
}

Json RepairReport::json_name(std::uint32_t row) const {
  const io::FeatureRange& feature = layer_.layer.features[row];
  return Json{{"file", layer_.layer.files[feature.file]}, {"feature", feature.feature}};
}

void RepairReport::add(const FeatureRepair& change) {
  changed_.push_back(change.feature);
  Json faults = Json::array();
  std::string said;
  for (const RepairFault fault : change.faults) {
    faults.push_back(oblast::to_text(fault));
    said += (said.empty() ? "" : ", ") + std::string(oblast::to_text(fault));
  }
  const std::string after =
      change.rings_after == 0 ? "nothing is left" : counted(change.rings_after, "ring") + " after";
  std::string line =
      fmt::format("{}: {}; {} before, {}", name(change.feature), said, counted(change.rings_before, "ring"), after);
  if (change.area_removed > 0) line += fmt::format("; area {:.6g} removed", change.area_removed);
  if (change.area_added > 0) line += fmt::format("; area {:.6g} added", change.area_added);
  lines_.push_back(std::move(line));
  Json object = json_name(change.feature);
  object.update(Json{{"faults", std::move(faults)},
                     {"rings_before", change.rings_before},
                     {"rings_after", change.rings_after},
                     {"rings_dropped", change.rings_dropped},
                     {"area_removed", change.area_removed},
                     {"area_added", change.area_added},
                     {"area_after", change.area_after}});
  changes_.push_back(std::move(object));
}

void RepairReport::add(const CoverageRepair& change) {
  std::string of;
  Json from = Json::array();
  for (const std::uint32_t row : change.from) {
    of += (of.empty() ? " of " : " and ") + name(row);
    from.push_back(json_name(row));
  }
  lines_.push_back(fmt::format("{}{} at {}, area {:.6g}: now in {}", word(change.change), of, text(change.at),
                               change.area, name(change.to)));
  changes_.push_back(Json{{"change", word(change.change)},
                          {"from", std::move(from)},
                          {"to", json_name(change.to)},
                          {"area", change.area},
                          {"at", {change.at.x, change.at.y}}});
}

void RepairReport::add(const Repaired& repaired) {
  for (const FeatureRepair& change : repaired.changed) add(change);
}

void RepairReport::add(const RepairedCoverage& repaired) {
  changed_ = repaired.changed;
  std::size_t counts[3] = {};
  for (const CoverageRepair& change : repaired.changes) {
    ++counts[static_cast<int>(change.change)];
    add(change);
  }
  gaps_left_ = repaired.gaps_left;
  counts_ = fmt::format("{} removed, {} closed, {} left, {} moved; ", counted(counts[0], "overlap"),
                        counted(counts[1], "gap"), counted(repaired.gaps_left, "gap"), counted(counts[2], "sliver"));
}

void RepairReport::add_empty(std::uint32_t row) {
  empty_.push_back(row);
  const FeatureView before = layer_.view();
  if (before.feature_begin(row) == before.feature_end(row)) ++were_empty_;
}

std::string RepairReport::to_text() const {
  std::string all = fmt::format("  repaired  {}{} of {} changed", counts_, changed_.size(),
                                counted(layer_.layer.features.size(), "feature"));
  if (const std::size_t vanished = empty_.size() - were_empty_; vanished > 0)
    all += fmt::format("; {} left without a geometry", vanished);
  if (dropped_ > 0) all += fmt::format("; {} without a geometry left out", counted(dropped_, "row"));
  all += '\n';
  for (std::size_t i = 0; i < std::min(lines_.size(), most_lines); ++i) all += fmt::format("    {}\n", lines_[i]);
  if (lines_.size() > most_lines) all += fmt::format("    and {} more; --json lists all\n", lines_.size() - most_lines);
  return all;
}

Json RepairReport::to_json() const {
  Json changed = Json::array(), empty = Json::array();
  for (const std::uint32_t row : changed_) changed.push_back(json_name(row));
  for (const std::uint32_t row : empty_) empty.push_back(json_name(row));
  Json object{{"changed_features", std::move(changed)},
              {"changes", changes_},
              {"features_without_geometry", std::move(empty)},
              {"rows_left_out", dropped_}};
  if (!gaps_left_.is_null()) object["gaps_left"] = gaps_left_;
  return object;
}

}  // namespace oblast::app
