// Options of reading, and notes on it; see inputs.h.
#include "oblast/inputs.h"

#include <fmt/format.h>
#include <oblast/measure.h>

#include <CLI/CLI.hpp>
#include <iterator>

#include "io/crs.h"
#include "io/paths.h"
#include "oblast/console.h"

namespace oblast::app {

namespace {

void add_crs_option(CLI::App& command, const std::string& option, std::string& wkt, const std::string& help) {
  command
      .add_option_function<std::string>(
          option,
          [&wkt, option](const std::string& word) {
            try {
              wkt = io::crs_from_text(word);
            } catch (const io::IoError& error) {
              throw CLI::ValidationError(option, error.what());
            }
          },
          help)
      ->type_name("CRS");
}

}  // namespace

void add_input_options(CLI::App& command, InputArguments& arguments) {
  command.add_option("--layer", arguments.layer, "the layer to read of files that have several (or write FILE:LAYER)")
      ->type_name("LAYER");
  add_crs_option(command, "--assume-crs", arguments.assume_crs,
                 "the coordinate system of files that name none, such as EPSG:4326");
  add_crs_option(command, "--t_srs", arguments.target_crs,
                 "transform the vertices of all input to this coordinate system, such as EPSG:3035");
}

io::ReadOptions read_options(const InputArguments& arguments, const std::string& output) {
  io::ReadOptions options;
  options.layer = arguments.layer;
  options.assume_crs = arguments.assume_crs;
  options.target_crs = arguments.target_crs;
  options.output = output == "-" ? "" : output;
  return options;
}

std::vector<std::string> reading_notes(const std::string& label, const io::Layer& layer) {
  const io::ReadReport& r = layer.report;
  std::vector<std::string> notes;
  const auto note = [&](const std::string& text) { notes.push_back(label + ": " + text); };
  const auto warning = [&](const std::string& text) { notes.push_back("warning: " + label + ": " + text); };
  for (const std::string& text : layer.notes) note(text);
  if (r.lines) note(counted(r.lines, "line feature") + " passed over");
  if (r.points) note(counted(r.points, "point feature") + " passed over");
  if (r.swapped)
    warning(fmt::format("longitude and latitude look swapped in {}; x must be the longitude",
                        layer.files.size() == 1 ? layer.files.front() : counted(r.swapped, "file")));
  if (r.beyond_pole) warning(counted(r.beyond_pole, "vertex") + " with a latitude beyond 90 degrees");
  if (r.across_date_line)
    warning(counted(r.across_date_line, layer.others.line_ends.empty() ? "polygon" : "polygon or line") +
            " across the date line; the plane ends there, so cut them at 180 degrees of longitude first");
  return notes;
}

std::vector<std::string> attributes_note(const std::string& label, const std::vector<std::string>& columns) {
  if (columns.empty()) return {};
  return {fmt::format("{}: {} passed over: {}", label,
                      columns.size() == 1 ? "1 attribute" : fmt::format("{} attributes", columns.size()),
                      io::name_list(columns))};
}

std::vector<std::string> apart_note(const std::string& label_a, const io::Layer& a, const std::string& label_b,
                                    const io::Layer& b) {
  if (a.regions.points.empty() || b.regions.points.empty()) return {};
  const Box box_a = *bounds(RegionView(a.regions)), box_b = *bounds(RegionView(b.regions));
  const auto meet = [](const Box& s, const Box& t) {
    return s.x0 <= t.x1 && t.x0 <= s.x1 && s.y0 <= t.y1 && t.y0 <= s.y1;
  };
  if (meet(box_a, box_b)) return {};
  const auto text = [](const Box& box) {
    return fmt::format("x {:.6g} to {:.6g}, y {:.6g} to {:.6g}", box.x0, box.x1, box.y0, box.y1);
  };
  const Box swapped{box_b.y0, box_b.x0, box_b.y1, box_b.x1};
  return {fmt::format("warning: {} and {} lie apart: {} has {}; {} has {}{}", label_a, label_b, label_a, text(box_a),
                      label_b, text(box_b),
                      meet(box_a, swapped) ? fmt::format("; x and y of {} or {} look swapped", label_a, label_b) : "")};
}

void require_same_crs(const std::string& label_a, const io::Layer& a, const std::string& label_b, const io::Layer& b) {
  io::require_same_crs(fmt::format("{} ({})", label_a, a.files.front()), a.crs_wkt,
                       fmt::format("{} ({})", label_b, b.files.front()), b.crs_wkt);
}

void print_notes(const std::vector<std::string>& notes) {
  for (const std::string& note : notes)
    fmt::print(stderr, "{}{}\n", note.starts_with("warning: ") ? "" : "note: ", note);
}

void append(std::vector<std::string>& notes, std::vector<std::string> more) {
  std::move(more.begin(), more.end(), std::back_inserter(notes));
}

}  // namespace oblast::app
