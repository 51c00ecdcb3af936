#include "oblast/buffer_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <utility>

#include "oblast/plane_choice.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(
The zone of all polygons, lines and points together, as one row; with --by-feature a row
for each feature, with its attributes. A negative distance gives the places inside the
polygons that are further than that from their outlines. The zone is valid. Its outline is
as near to the true one as --tolerance says. The zone holds its input, or lies in it; with
bevels, flat caps or --crs there may be rounding in the last digits.

A distance without a unit is in the unit of the coordinates. Longitudes and latitudes
have no unit of length: with `--crs auto` such a layer is computed in a projected system
that fits it, and the zone comes back in longitudes and latitudes. `--crs EPSG:N` chooses
the system. Edges are straight in that system, so cut very long ones first.

A column as the distance holds numbers in the unit of the coordinates (with --crs: of that
system; for auto metres).

Example: everything within 500 m of a road
  oblast buffer roads.gpkg --distance 500m -o near.gpkg

Example: fields without a strip of 10 m along their outlines, field by field
  oblast buffer fields.gpkg --distance=-10m --by-feature -o inner.gpkg)";

// An option with some words to choose from.
template <class Value>
void add_choice(CLI::App& command, const std::string& name, Value& value,
                std::vector<std::pair<std::string, Value>> words, const std::string& help, const std::string& type) {
  command
      .add_option_function<std::string>(
          name,
          [&value, words = std::move(words), name](const std::string& given) {
            std::string known;
            for (const auto& [word, meaning] : words) {
              if (word == given) {
                value = meaning;
                return;
              }
              known += (known.empty() ? "" : &word == &words.back().first ? " or " : ", ") + word;
            }
            throw CLI::ValidationError(name, fmt::format("there is no '{}'; choose {}", given, known));
          },
          help)
      ->type_name(type);
}

void add_shape_options(CLI::App& command, BufferArguments& arguments) {
  BufferOptions& options = arguments.options;
  command
      .add_option("--tolerance", arguments.tolerance,
                  "how far the outline may be from the true one: a share of the distance such as 0.01 or 1% "
                  "(default), or a length such as 0.5m")
      ->type_name("T");
  add_choice<Join>(command, "--join", options.join,
                   {{"round", Join::round}, {"mitre", Join::mitre}, {"bevel", Join::bevel}},
                   "the outline around corners: round (default), mitre or bevel", "JOIN");
  BufferArguments* const a = &arguments;
  command
      .add_option_function<double>(
          "--mitre-limit",
          [a](double limit) {
            if (!(limit >= 1 && std::isfinite(limit)))
              throw CLI::ValidationError("--mitre-limit", "the limit must be 1 or more");
            a->options.mitre_limit = limit;
            a->mitre_limit_given = true;
          },
          "with --join mitre: how far a corner may reach, as a multiple of the distance (default: 5)")
      ->type_name("M");
  add_choice<Cap>(command, "--cap", options.cap, {{"round", Cap::round}, {"flat", Cap::flat}, {"square", Cap::square}},
                  "the outline around the ends of lines: round (default), flat or square", "CAP");
  add_choice<Side>(command, "--side", options.side,
                   {{"both", Side::both}, {"left", Side::left}, {"right", Side::right}},
                   "the sides of lines, as seen along them: both (default), left or right", "SIDE");
  add_choice<BufferMode>(
      command, "--mode", options.mode,
      {{"nearest", BufferMode::nearest}, {"inside", BufferMode::inside}, {"outside", BufferMode::outside}},
      "where the outline may be: nearest (default, on both sides of the true one), inside (nothing further than the "
      "distance) or outside (nothing within the distance is missed)",
      "MODE");
}

}  // namespace

CLI::App* add_buffer_options(CLI::App& program, BufferArguments& arguments, Invocation& invocation) {
  BufferArguments* const a = &arguments;
  CLI::App* command = program.add_subcommand("buffer", "All places within a distance of polygons, lines and points.");
  command->footer(footer);
  command->add_option("IN", a->inputs, input_help)->required()->type_name("");
  command
      ->add_option("--distance", a->distance,
                   "how far: a number with a unit (m, km, cm, ft, us-ft, mi, degrees) or in that of the coordinates; "
                   "or the name of a column of numbers")
      ->required()
      ->type_name("D");
  add_shape_options(*command, *a);
  command->add_flag("--by-feature", a->by_feature, "a row for each feature, with its attributes (default: one row)");
  command->add_option("--crs", a->crs, plane_help)->type_name("CRS");
  add_row_options(*command, a->rows, Select::columns);
  add_zone_file_options(*command, a->job, invocation);
  return command;
}

}  // namespace oblast::app
