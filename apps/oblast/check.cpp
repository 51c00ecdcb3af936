// `oblast check`: proves that a file is closed (G2). Options: whether it is canonical (G3), and the right result.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "io/read.h"
#include "oblast/check_against.h"
#include "oblast/check_rows.h"
#include "oblast/command.h"
#include "oblast/console.h"
#include "oblast/names.h"
#include "verify/verify.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(
The command proves, with exact arithmetic: edges meet only at common end points.
Contours do not cross, overlap or repeat. Outer contours run counter-clockwise. Holes
run clockwise and lie inside their own outer contour. Polygons do not overlap. The
directions of rings are those in the file. If the format prescribes other directions
(Shapefile), the directions that GDAL reads count.

--canonical also checks the order that oblast writes: each contour starts at its
lexicographically smallest vertex, and holes and polygons are sorted.

--rows takes each feature of FILE as a row, as `oblast overlay` writes them. Rows may
overlap. The command proves that each is closed and canonical, and that edges of different
rows are identical or meet at common end points only.

--against also checks whether FILE is the right result for the operands. It tests many
points: some anywhere, some a few units in the last place beside edges, vertices and
crossings. Each must be inside FILE exactly if the operation says so. It also tests all
stretches of many lines. The decisions are exact, and the code is independent of the
overlay. Without --op the operands are united, as by `oblast union`.

Examples
  oblast check burnt.gpkg && echo fit for any GIS
  oblast check burnt.gpkg --against fires/
  oblast check communes_by_fire.gpkg --rows
  oblast check new.gpkg --against june.gpkg may.gpkg --op difference --points 1000000)";

struct Arguments {
  std::string file;
  bool canonical = false;
  bool rows = false;
  ContourConvention convention = ContourConvention::ogc;
  AgainstArguments against;
};

int run(const Arguments& arguments, bool json) {
  if (arguments.rows) {
    if (arguments.canonical || !arguments.against.operands.empty())
      throw CallError("--rows checks the order of each row anyway, and has no --against; leave out the other option");
    return check_rows(arguments.file, arguments.convention, json);
  }
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
  command->add_flag("--canonical", arguments->canonical, "also check that the order is canonical");
  command->add_flag("--rows", arguments->rows, "check that each feature is a row, and that rows fit together");
  command
      ->add_option_function<std::string>(
          "--contours", [arguments](const std::string& word) { arguments->convention = parse_contours(word); },
          "how contours of FILE may touch themselves: ogc (default) or leonov-nikitin")
      ->type_name("CONVENTION");
  add_against_options(*command, arguments->against);
  command->add_flag("--json", invocation.json, "print the findings as one JSON object on standard output");
  command->callback([arguments, &invocation] {
    invocation.run = [arguments, &invocation] { return run(*arguments, invocation.json); };
  });
}

}  // namespace oblast::app
