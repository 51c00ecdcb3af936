// `oblast check`: whether a file is what it is taken for. By default its features, on request more (see the footer).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "oblast/check_layer.h"
#include "oblast/check_regions.h"
#include "oblast/check_rows.h"
#include "oblast/command.h"
#include "oblast/names.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(
Without an option the command checks each feature by itself. A feature must be a valid
polygon or multipolygon, as the OGC defines it. Faults are: a ring is not closed, has too
few points, has a spike, crosses itself, touches itself, or runs along itself; a ring is
repeated; a hole crosses its shell or lies outside it; holes overlap; rings of a polygon
share an edge; rings touch so that the interior is cut in two; parts of a multipolygon
overlap or share an edge. Repeated vertices, and shells or holes that run in the wrong
direction, are notes: the feature is valid all the same.

--coverage also looks between the features. Faults are: two features overlap; features
enclose a gap; a vertex of one lies on an edge of another where its border turns away
(T-junction) or goes on along the edge (mismatched vertices). A hole of a single feature
is no gap.

The command counts all faults by kind and lists the first 20, each with its place and the
feature, part, ring and vertex on both sides. Features have the numbers of the file. Parts
and rings count from 1, vertices from 0. An edge has the number of a vertex at one of its
ends. --faults writes all faults and notes as points, --svg draws them, and --json prints
them. All decisions are exact: there is no tolerance.

--regions takes the whole file as one region set, as `oblast union` writes it, and proves:
edges meet only at common end points, polygons do not overlap, outer rings run
counter-clockwise and holes clockwise. It stops at the first fault. --canonical also
checks the order that oblast writes. The code is independent of the overlay.

--rows takes the features as rows, as `oblast overlay` writes them. Rows may overlap, which
--coverage does not admit. But each must be a canonical region set, and edges of different
rows must be identical or meet at common end points only. It stops at the first fault.

--against checks whether FILE is the right result for the operands. It tests many points:
some anywhere, some a few units in the last place beside edges, vertices and crossings.
Each must be inside FILE exactly if the operation says so. It also tests all stretches of
many lines. Without --op the operands are united, as by `oblast union`.

The exit code is 0 if there is no fault, and 1 if there is one.

Examples
  oblast check parcels.gpkg
  oblast check parcels.gpkg --coverage --faults faults.gpkg --svg faults.png
  oblast check burnt.gpkg --regions && echo fit for any GIS
  oblast check communes_by_fire.gpkg --rows
  oblast check new.gpkg --against june.gpkg may.gpkg --op difference --points 1000000)";

struct Arguments {
  LayerCheckArguments features;
  RegionCheckArguments regions;
  bool as_regions = false;
  bool as_rows = false;
};

int run(Arguments arguments, bool json) {
  const bool against = !arguments.regions.against.operands.empty();
  if (arguments.as_rows && (arguments.regions.canonical || against))
    throw CallError("--rows checks the order of each row anyway, and has no --against; leave out the other option");
  const bool regions = arguments.as_regions || arguments.regions.canonical || against;
  if (arguments.features.coverage + arguments.as_rows + regions > 1)
    throw CallError("--coverage, --rows and --regions (also --canonical and --against) are different checks; name one");
  if ((arguments.as_rows || regions) && !(arguments.features.faults.empty() && arguments.features.picture.empty()))
    throw CallError(
        fmt::format("{} goes with the check of features or of a coverage; --rows and --regions stop at the "
                    "first fault",
                    arguments.features.faults.empty() ? "--svg" : "--faults"));
  if (arguments.features.overwrite && arguments.features.faults.empty() && arguments.features.picture.empty())
    throw CallError("--overwrite goes with --faults or --svg; without them no file is written");
  if (arguments.as_rows)
    return check_rows(arguments.features.input, arguments.regions.convention, arguments.features.quiet, json);
  arguments.regions.input = arguments.features.input;
  arguments.regions.quiet = arguments.features.quiet;
  if (regions) return check_regions(arguments.regions, json);
  check_call(arguments.features.input.file, arguments.regions.against);
  arguments.features.threads = arguments.regions.against.threads;
  arguments.features.json = json;
  return check_layer(arguments.features);
}

}  // namespace

void add_check(CLI::App& program, Invocation& invocation) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("check", "Find all faults of features, of a coverage, or of a result.");
  command->footer(footer);
  add_check_input(*command, arguments->features.input);
  command->add_flag("--coverage", arguments->features.coverage,
                    "also find overlaps, gaps and vertices that do not match between features");
  command
      ->add_option("--faults", arguments->features.faults,
                   "write all faults as a point layer: .gpkg, .shp, .geojson, .fgb or .wkt")
      ->type_name("FILE");
  command
      ->add_option("--svg,--picture", arguments->features.picture,
                   "draw the features and a dot at each fault, coloured by its kind: a name in .svg or .png")
      ->type_name("PICTURE");
  command->add_flag("--overwrite", arguments->features.overwrite,
                    "with --faults or --svg: replace existing files of these names");
  command->add_flag("--regions", arguments->as_regions, "prove that the whole file is one valid region set");
  command->add_flag("--canonical", arguments->regions.canonical, "the same, and that its order is canonical");
  command->add_flag("--rows", arguments->as_rows, "prove that the features are rows of a result that fit together");
  command
      ->add_option_function<std::string>(
          "--contours", [arguments](const std::string& word) { arguments->regions.convention = parse_contours(word); },
          "with --regions or --rows: how contours may touch themselves, ogc (default) or leonov-nikitin")
      ->type_name("CONVENTION");
  add_against_options(*command, arguments->regions.against);
  command->add_flag("-q,--quiet", arguments->features.quiet, "print no progress");
  command->add_flag("--json", invocation.json, "print all findings as one JSON object on standard output");
  command->callback([arguments, &invocation] {
    invocation.run = [arguments, &invocation] { return run(*arguments, invocation.json); };
  });
}

}  // namespace oblast::app
