// What `oblast repair` changed, as text and as JSON.
#pragma once

#include <oblast/repair.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/rows.h"

namespace oblast::app {

class RepairReport {
 public:
  /// REQUIRES: the layer outlives the report.
  explicit RepairReport(const io::Rows& layer) : layer_(layer) {}

  void add(const Repaired& repaired);
  void add(const RepairedCoverage& repaired);
  /// A row that has no geometry now.
  void add_empty(std::uint32_t row);
  /// How many of these are not written.
  void set_dropped(std::size_t rows) { dropped_ = rows; }

  /// One line with all counts, and one for each of the first changes.
  std::string to_text() const;
  /// Members of the summary: all changes.
  nlohmann::ordered_json to_json() const;

 private:
  /// "feature 17", with its file if there are several.
  std::string name(std::uint32_t row) const;
  nlohmann::ordered_json json_name(std::uint32_t row) const;
  void add(const FeatureRepair& change);
  void add(const CoverageRepair& change);

  const io::Rows& layer_;
  std::string counts_;  ///< of a coverage
  std::vector<std::string> lines_;
  nlohmann::ordered_json changes_ = nlohmann::ordered_json::array();
  std::vector<std::uint32_t> changed_, empty_;  ///< rows
  std::size_t were_empty_ = 0;                  ///< of the empty ones: before, too
  std::size_t dropped_ = 0;
  nlohmann::ordered_json gaps_left_;  ///< null: no coverage
};

}  // namespace oblast::app
