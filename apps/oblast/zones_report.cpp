#include "oblast/zones_report.h"

#include <fmt/format.h>

#include "io/crs.h"
#include "io/row_measures.h"
#include "oblast/console.h"

namespace oblast::app {

void ZonesReport::describe(const std::string& crs_wkt) {
  unit = io::RowMeasures(crs_wkt).coordinate_unit();
  crs = crs_wkt.empty() ? "the plane of the coordinates" : io::crs_name(crs_wkt);
}

nlohmann::ordered_json ZonesReport::to_json() const {
  const ZoneStatistics& s = statistics;
  return {{"zones",
           {{"objects", objects},
            {"without_zone", without_zone},
            {"sites", s.sites},
            {"rounds", s.rounds},
            {"tolerance", s.tolerance},
            {"error", s.error},
            {"rounding", s.rounding},
            {"unit", unit},
            {"computed_in", crs}}}};
}

std::string ZonesReport::to_text() const {
  const ZoneStatistics& s = statistics;
  std::string text = fmt::format("  nearest   up to {:.2g} {} of distance, and {:.2g} {} for rounding, in {}\n",
                                 s.error, unit, s.rounding, unit, crs);
  text += fmt::format("  objects   {}, as {} in {}\n", counted(objects, "object"), counted(s.sites, "site"),
                      counted(s.rounds, "round"));
  return text;
}

}  // namespace oblast::app
