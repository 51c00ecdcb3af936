#include "oblast/no_polygons.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "oblast/command.h"
#include "oblast/console.h"

namespace oblast::app {

std::string lines_and_points(const io::ReadReport& report) {
  std::string text;
  if (report.lines > 0) text = counted(report.lines, "line");
  if (report.points > 0) text += (text.empty() ? "" : " and ") + counted(report.points, "point");
  return text;
}

std::optional<int> say_no_polygons(const std::string& file, const io::Layer& layer, bool json) {
  if (!layer.regions.contour_ends.empty()) return {};
  const std::string others = lines_and_points(layer.report);
  const std::string name = file == "-" ? "standard input" : file;
  const std::string what =
      others.empty()
          ? fmt::format("{} has no polygons: {}", name,
                        layer.report.features == 0 ? "it has no features"
                                                   : counted(layer.report.features, "feature") + " without geometry")
          : fmt::format("{} has no polygons, only {}; there is nothing to check", name, others);
  if (json) {
    nlohmann::ordered_json object{{"file", file}, {"polygons", 0}, {"note", what}};
    fmt::print("{}\n", object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  } else {
    fmt::print("{}\n", what);
  }
  return others.empty() ? exit_done : exit_data;
}

}  // namespace oblast::app
