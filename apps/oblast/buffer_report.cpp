#include "oblast/buffer_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/crs.h"
#include "io/row_measures.h"
#include "oblast/console.h"

namespace oblast::app {

void BufferReport::describe(std::span<const double> distances, const std::string& crs_wkt) {
  if (!distances.empty()) {
    const auto [least, most] = std::minmax_element(distances.begin(), distances.end());
    least_distance = *least;
    most_distance = *most;
  }
  unit = io::RowMeasures(crs_wkt).coordinate_unit();
  crs = crs_wkt.empty() ? "the plane of the coordinates" : io::crs_name(crs_wkt);
}

nlohmann::ordered_json BufferReport::to_json() const {
  const BufferStatistics& s = statistics;
  return {{"buffer",
           {{"least_distance", least_distance},
            {"most_distance", most_distance},
            {"unit", unit},
            {"computed_in", crs},
            {"lower_factor", s.lower_factor},
            {"upper_factor", s.upper_factor},
            {"rounding", s.rounding},
            {"directions", s.directions},
            {"corners", s.corners},
            {"closed_pockets", s.closed_pockets},
            {"folded_pieces", s.folded_pieces}}}};
}

std::string BufferReport::to_text() const {
  const BufferStatistics& s = statistics;
  std::string text = least_distance == most_distance
                         ? fmt::format("  distance  {:.10g} {}", least_distance, unit)
                         : fmt::format("  distance  {:.10g} to {:.10g} {}", least_distance, most_distance, unit);
  text += fmt::format(", in {}; the outline is {:.6g} to {:.6g} of it from the input, and {:.2g} {} for rounding\n",
                      crs, s.lower_factor, s.upper_factor, s.rounding, unit);
  text += fmt::format("  pieces    {}, {} in a circle{}\n", counted(s.corners, "corner"),
                      counted(s.directions, "direction"),
                      s.closed_pockets ? ", " + counted(s.closed_pockets, "narrow pocket") + " closed" : "");
  return text;
}

}  // namespace oblast::app
