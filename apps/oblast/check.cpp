// `oblast check`: proves that a file is closed (G2), and on request canonical (G3) and the right answer.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "io/read.h"
#include "oblast/check_against.h"
#include "oblast/command.h"
#include "oblast/console.h"
#include "oblast/names.h"
#include "verify/verify.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(
Proved exactly, with rational arithmetic where it is needed: edges meet only at
common end points; contours do not cross, overlap or repeat; outer contours run
counter-clockwise and holes clockwise, inside their own outer contour; polygons do
not overlap. The directions of rings are those of the file; where its format turns
them (Shapefile), what GDAL reads counts.

With --canonical also the order that oblast writes: each contour from its
lexicographically smallest vertex, polygons and holes in order.

With --against also whether FILE is what oblast should have made of the operands: many
points, anywhere and a few units in the last place beside edges, vertices and crossings,
must be inside the result just where the operation says, decided exactly; so must all
stretches of many lines. Without --op all operands are united, as by `oblast union`.
Code of its own does this; it shares none with the overlay.

Examples
  oblast check burnt.gpkg && echo fit for any GIS
  oblast check burnt.gpkg --against fires/
  oblast check new.gpkg --against june.gpkg may.gpkg --op difference --points 1000000)";

struct Arguments {
  std::string file;
  bool canonical = false;
  ContourConvention convention = ContourConvention::ogc;
  AgainstArguments against;
};

// Faults that reading mends would go unseen: they are told from the report.
std::string mended(const io::ReadReport& report) {
  if (report.repeated_vertices)
    return counted(report.repeated_vertices, "repeated vertex") + " in the file, dropped on reading";
  if (report.unclosed_contours)
    return counted(report.unclosed_contours, "unclosed contour") + " in the file, closed on reading";
  return {};
}

int run(const Arguments& arguments, bool json) {
  check_call(arguments.file, arguments.against);
  const std::vector<std::string> paths{arguments.file};
  const io::Layer layer = io::read(paths);
  const RegionView regions = layer.regions;
  std::optional<verify::Fault> fault = verify::check_closed(regions, arguments.convention);
  const bool closed = !fault;
  if (closed && arguments.canonical) fault = verify::check_canonical(regions);
  std::string place, what;
  if (fault) {
    place = io::describe(layer, fault->place);
    what = fault->what;
  }
  const std::string note = mended(layer.report);
  std::optional<AgainstFindings> findings;
  if (!fault && !arguments.against.operands.empty()) findings = check_against(layer, arguments.against);
  if (json) {
    nlohmann::ordered_json object{{"file", arguments.file},
                                  {"closed", closed},
                                  {"polygons", regions.polygon_count()},
                                  {"contours", regions.contour_count()},
                                  {"vertices", regions.points.size()}};
    if (arguments.canonical && closed) object["canonical"] = !fault;
    if (fault) object["fault"] = {{"what", what}, {"place", place}};
    if (!note.empty()) object["note"] = note;
    if (findings) object["against"] = findings->json;
    fmt::print("{}\n", object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  } else if (fault) {
    fmt::print("{}: {}\n  at {}\n", closed ? "not canonical" : "not closed", what,
               place.empty() ? arguments.file : place);
  } else {
    fmt::print("{}: {}, {}, {}\n", arguments.canonical ? "closed and canonical" : "closed",
               counted(regions.polygon_count(), "polygon"), counted(regions.contour_count(), "contour"),
               counted(regions.points.size(), "vertex"));
  }
  if (!json && !note.empty()) fmt::print("  note: {}\n", note);
  if (!json && findings) fmt::print("{}", findings->text);
  return fault || (findings && !findings->right) ? exit_data : exit_done;
}

}  // namespace

void add_check(CLI::App& program, Invocation& invocation) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      program.add_subcommand("check", "Prove that a file is a valid region set, or name the first fault.");
  command->footer(footer);
  command->add_option("FILE", arguments->file, "a vector file, a folder, or `-` for WKT on standard input")
      ->required()
      ->type_name("");
  command->add_flag("--canonical", arguments->canonical, "the order must be canonical, too");
  command
      ->add_option_function<std::string>(
          "--contours", [arguments](const std::string& word) { arguments->convention = parse_contours(word); },
          "ogc (default) or leonov-nikitin: what contours may touch themselves")
      ->type_name("CONVENTION");
  add_against_options(*command, arguments->against);
  command->add_flag("--json", invocation.json, "one object on standard output");
  command->callback([arguments, &invocation] {
    invocation.run = [arguments, &invocation] { return run(*arguments, invocation.json); };
  });
}

}  // namespace oblast::app
