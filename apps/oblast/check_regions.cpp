// The proof of region sets by verify/, which shares no code with the overlay; see check_regions.h.
#include "oblast/check_regions.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "io/read.h"
#include "oblast/check_rows.h"
#include "oblast/command.h"
#include "oblast/console.h"
#include "oblast/no_polygons.h"
#include "verify/verify.h"

namespace oblast::app {

int check_regions(const RegionCheckArguments& arguments, bool json) {
  const std::string& path = arguments.input.file;
  check_call(path, arguments.against);
  JobProgress progress(!arguments.quiet, false);
  const io::Layer layer = read_to_check(arguments.input, {}, progress);
  if (layer.regions.contour_ends.empty()) progress.clear();
  if (!lines_and_points(layer.report).empty())
    if (const auto code = say_no_polygons(path, layer, json)) return *code;
  progress.show(Phase::computing, "proving", 0);
  const RegionView regions = layer.regions;
  std::optional<verify::Fault> fault = verify::check_closed(regions, arguments.convention);
  const bool valid = !fault;
  if (valid && arguments.canonical) fault = verify::check_canonical(regions);
  std::string place, what;
  if (fault) {
    place = io::describe(layer, fault->place);
    what = fault->what;
  }
  const std::string note = mended(layer.report);
  std::optional<AgainstFindings> findings;
  if (!fault && !arguments.against.operands.empty())
    findings = check_against(layer, arguments.against, arguments.input.input);
  progress.clear();
  if (json) {
    nlohmann::ordered_json object{{"file", path},
                                  {"valid", valid},
                                  {"polygons", regions.polygon_count()},
                                  {"contours", regions.contour_count()},
                                  {"vertices", regions.points.size()}};
    if (arguments.canonical && valid) object["canonical"] = !fault;
    if (fault) object["fault"] = {{"what", what}, {"place", place}};
    if (!note.empty()) object["note"] = note;
    if (findings) object["against"] = findings->json;
    fmt::print("{}\n", object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  } else if (fault) {
    fmt::print("{}: {}\n  at {}\n", valid ? "not in canonical order" : "not a valid region set", what,
               place.empty() ? path : place);
  } else {
    fmt::print("{}: {}, {}, {}\n", arguments.canonical ? "valid region set in canonical order" : "valid region set",
               counted(regions.polygon_count(), "polygon"), counted(regions.contour_count(), "contour"),
               counted(regions.points.size(), "vertex"));
  }
  if (!json && !note.empty()) fmt::print("  note: {}\n", note);
  if (!json && findings) fmt::print("{}", findings->text);
  return fault || (findings && !findings->right) ? exit_data : exit_done;
}

}  // namespace oblast::app
