// The summary of a job, as text and as JSON.
#pragma once

#include <oblast/options.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/layer.h"

namespace oblast::app {

struct OperandSummary {
  std::string label;               ///< "A" or "B"; "input" if there is only one operand
  std::vector<std::string> paths;  ///< as on the command line
  io::ReadReport report;
  std::uint64_t files = 0;
  std::uint64_t polygons = 0;
  std::uint64_t contours = 0;
  std::uint64_t vertices = 0;
  std::uint64_t lines = 0;   ///< that were kept
  std::uint64_t points = 0;  ///< that were kept
};

struct Summary {
  std::string command;
  std::vector<OperandSummary> operands;
  std::string output;
  std::string picture;  ///< empty: none
  std::string crs;      ///< name of the coordinate system
  Engine engine = Engine::leonov_nikitin;
  Statistics statistics;
  std::optional<std::uint64_t> rows;  ///< of the result, if it has rows
  std::uint64_t columns = 0;          ///< of its table
  std::vector<std::string> notes;     ///< on the reading and on the file that was written: one line each
  std::vector<std::string> units;     ///< of the measures: one line each
  bool noded = true;                  ///< false: the command counts no intersections
  nlohmann::ordered_json more;        ///< members that only this command has; null: none
  double area = 0;                    ///< of all rows together, in squared units of the coordinates
  std::string area_text;              ///< the same for a reader; made only if the summary is shown as text
  std::string unit = "units";         ///< of the coordinates: "degrees", "m"
  double seconds_read = 0;
  double seconds_write = 0;
  double seconds_picture = 0;
  double seconds_total = 0;
};

/// Sets the parts of the summary that depend on the coordinate system. `text` is false if only JSON will be shown.
void add_measures(Summary& summary, const RegionView& regions, const std::string& crs_wkt, bool text);

OperandSummary summarise(const std::string& label, const std::vector<std::string>& paths, const io::Layer& layer);

/// Prints the notes, also if the user wants no summary: what was passed over must not go unsaid. Then the summary, as
/// text or as JSON, which has the notes, too.
void report(const Summary& summary, bool json, bool quiet);

/// A few lines. The last one also ends with a line break.
std::string to_text(const Summary& summary);
nlohmann::ordered_json to_json(const Summary& summary);

}  // namespace oblast::app
