// The summary at the end of `union` and `overlay`.
#include "oblast/summary.h"

#include <fmt/format.h>

#include "io/crs.h"
#include "io/row_measures.h"
#include "oblast/console.h"
#include "oblast/inputs.h"
#include "oblast/names.h"
#include "oblast/outputs.h"

namespace oblast::app {

namespace {

using Json = nlohmann::ordered_json;

std::string line(const std::string& head, const std::string& text) { return fmt::format("  {:<9} {}\n", head, text); }

void append_item(std::string& list, const std::string& text) { list += (list.empty() ? "" : ", ") + text; }

// Each note about the files appears once, with the number of features that it concerns.
std::string notes(const OperandSummary& operand) {
  const io::ReadReport& r = operand.report;
  std::string text;
  if (r.with_z) append_item(text, counted(r.with_z, "feature") + " with Z, which was ignored");
  if (r.with_m) append_item(text, counted(r.with_m, "feature") + " with M, which was ignored");
  if (r.null_geometries) append_item(text, counted(r.null_geometries, "null geometry"));
  if (r.empty_geometries) append_item(text, counted(r.empty_geometries, "empty geometry"));
  if (r.unclosed_contours) append_item(text, counted(r.unclosed_contours, "unclosed contour") + " closed");
  if (r.repeated_vertices) append_item(text, counted(r.repeated_vertices, "repeated vertex") + " dropped");
  return text;
}

std::string others(const OperandSummary& operand) {
  std::string text;
  if (operand.lines > 0) text += ", " + counted(operand.lines, "line");
  if (operand.points > 0) text += ", " + counted(operand.points, "point");
  return text;
}

std::string stage_times(const Summary& summary) {
  std::string text = fmt::format("{:.3f} s: read {:.3f}", summary.seconds_total, summary.seconds_read);
  for (int stage = 0; stage < stage_count; ++stage) {
    append_item(text, fmt::format("{} {:.3f}", name(static_cast<Stage>(stage)), summary.statistics.seconds[stage]));
  }
  append_item(text, fmt::format("write {:.3f}", summary.seconds_write));
  if (!summary.picture.empty()) append_item(text, fmt::format("picture {:.3f}", summary.seconds_picture));
  return text;
}

double engine_seconds(const Statistics& statistics) {
  double sum = 0;
  for (const double seconds : statistics.seconds) sum += seconds;
  return sum;
}

Json to_json(const OperandSummary& operand) {
  const io::ReadReport& r = operand.report;
  return Json{{"label", operand.label},
              {"paths", operand.paths},
              {"files", operand.files},
              {"features", r.features},
              {"polygons", operand.polygons},
              {"contours", operand.contours},
              {"vertices", operand.vertices},
              {"lines", operand.lines},
              {"points", operand.points},
              {"null_geometries", r.null_geometries},
              {"empty_geometries", r.empty_geometries},
              {"lines_passed_over", r.lines},
              {"points_passed_over", r.points},
              {"features_with_z", r.with_z},
              {"features_with_m", r.with_m},
              {"vertices_beyond_pole", r.beyond_pole},
              {"polygons_across_date_line", r.across_date_line},
              {"unclosed_contours", r.unclosed_contours},
              {"repeated_vertices", r.repeated_vertices}};
}

}  // namespace

void add_measures(Summary& summary, const RegionView& regions, const std::string& crs_wkt, bool text) {
  const io::RowMeasures measures(crs_wkt);
  summary.crs = io::crs_name(crs_wkt);
  summary.unit = measures.coordinate_unit();
  summary.area = signed_area(regions);
  if (text) summary.area_text = measures.area_text(regions);
}

void report(const Summary& summary, bool json, bool quiet) {
  // JSON on standard error is the only thing there.
  if (!json || summary.output != "-") {
    print_notes(summary.notes);
    if (!quiet) print_notes(summary.units);
  }
  if (json) {
    print_json(to_json(summary), summary.output);
  } else if (!quiet) {
    fmt::print(stderr, "{}", to_text(summary));
  }
}

OperandSummary summarise(const std::string& label, const std::vector<std::string>& paths, const io::Layer& layer) {
  const RegionView view = layer.regions;
  return {label,
          paths,
          layer.report,
          layer.files.size(),
          view.polygon_count(),
          view.contour_count(),
          view.points.size(),
          layer.others.line_ends.size(),
          layer.others.points.size()};
}

std::string to_text(const Summary& summary) {
  const Statistics& s = summary.statistics;
  std::string text =
      fmt::format("{} -> {}\n", summary.command, summary.output == "-" ? "standard output" : summary.output);
  for (const OperandSummary& operand : summary.operands) {
    text += line(
        operand.label,
        fmt::format("{}, {}, {}, {}{}", counted(operand.files, "file"), counted(operand.report.features, "feature"),
                    counted(operand.contours, "contour"), counted(operand.vertices, "vertex"), others(operand)));
    if (const std::string said = notes(operand); !said.empty()) text += line("", said);
  }
  const std::string rows = summary.rows ? counted(*summary.rows, "row") + ", " : "";
  text += line("result", fmt::format("{}{}, {}, {}", rows, counted(s.output_polygons, "polygon"),
                                     counted(s.output_contours, "contour"), counted(s.output_vertices, "vertex")));
  text += line("area", fmt::format("{}; coordinate system: {}", summary.area_text, summary.crs));
  if (summary.noded)
    text += line("noding", fmt::format("{}, {}, largest displacement {:.3g} {} ({:.2f} ulp)",
                                       counted(s.intersections, "intersection"), counted(s.rounds, "round"),
                                       s.largest_displacement, summary.unit, s.largest_displacement_ulps));
  if (s.resolved_polygons)
    text += line("", counted(s.resolved_polygons, "polygon") + " with rings that meet; resolved first");
  text += line("time", stage_times(summary));
  text += line("memory", fmt::format("{:.0f} MiB at the peak", static_cast<double>(peak_memory()) / (1 << 20)));
  if (!summary.picture.empty()) text += line("picture", summary.picture);
  return text;
}

Json to_json(const Summary& summary) {
  const Statistics& s = summary.statistics;
  Json operands = Json::array();
  for (const OperandSummary& operand : summary.operands) operands.push_back(to_json(operand));
  Json seconds{{"total", summary.seconds_total}, {"read", summary.seconds_read}};
  for (int stage = 0; stage < stage_count; ++stage) seconds[name(static_cast<Stage>(stage))] = s.seconds[stage];
  seconds["overlay"] = engine_seconds(s);
  seconds["write"] = summary.seconds_write;
  seconds["picture"] = summary.seconds_picture;
  Json object{{"command", summary.command},
              {"output", summary.output},
              {"crs", summary.crs},
              {"engine", name(summary.engine)},
              {"operands", std::move(operands)},
              {"result",
               {{"polygons", s.output_polygons},
                {"contours", s.output_contours},
                {"vertices", s.output_vertices},
                {"area", summary.area},
                {"area_unit", "square " + summary.unit}}},
              {"intersections", s.intersections},
              {"rounds", s.rounds},
              {"largest_displacement", s.largest_displacement},
              {"largest_displacement_ulps", s.largest_displacement_ulps},
              {"resolved_polygons", s.resolved_polygons},
              {"seconds", std::move(seconds)},
              {"peak_memory_bytes", peak_memory()}};
  if (summary.rows) {
    object["result"]["rows"] = *summary.rows;
    object["result"]["columns"] = summary.columns;
  }
  object["notes"] = summary.notes;
  for (const std::string& unit : summary.units) object["notes"].push_back(unit);
  if (!summary.picture.empty()) object["picture"] = summary.picture;
  if (!summary.more.is_null()) object.update(summary.more);
  return object;
}

}  // namespace oblast::app
