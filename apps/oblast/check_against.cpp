// Reads the operands, calls the oracle, and reports its findings.
#include "oblast/check_against.h"

#include <fmt/format.h>
#include <oblast/domain.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "io/crs.h"
#include "io/read.h"
#include "oblast/command.h"
#include "oblast/console.h"
#include "oblast/names.h"
#include "verify/edges.h"
#include "verify/exact_sum.h"
#include "verify/oracle.h"

namespace oblast::app {

namespace {

constexpr const char* kind_names[verify::probe_kinds] = {"anywhere", "by edges", "by vertices", "by crossings",
                                                         "vertices of the result"};

// `oblast union` makes one operand of all files; `oblast overlay` takes two.
bool is_overlay(const AgainstArguments& arguments) { return arguments.operation && arguments.operands.size() == 2; }

void check_domain(const io::Layer& layer) {
  for (std::size_t c = 0; c < layer.regions.contour_ends.size(); ++c) {
    const auto contour = layer.regions.view().contour(c);
    for (std::size_t v = 0; v < contour.size(); ++v) {
      if (in_domain(contour[v].x) && in_domain(contour[v].y)) continue;
      Place place;
      place.contour = c;
      place.vertex = v;
      throw io::IoError(io::describe(layer, place) +
                        ": a coordinate is outside the domain: its magnitude must be 0 or between 2^-300 and 2^300");
    }
  }
}

io::Layer read_operand(const std::vector<std::string>& paths, const io::Layer& result, int threads,
                       const InputArguments& input) {
  io::ReadOptions options;
  options.assume_crs = input.assume_crs;
  options.target_crs = input.target_crs;
  options.threads = threads;
  io::Layer layer = io::read(paths, options);
  check_domain(layer);
  if (!io::same_crs(layer.crs_wkt, result.crs_wkt)) {
    throw io::IoError(
        fmt::format("two coordinate systems: {} is in {}, but the result is in {}; transform one of them "
                    "first",
                    layer.files.front(), io::crs_name(layer.crs_wkt), io::crs_name(result.crs_wkt)));
  }
  return layer;
}

struct Judgement {
  verify::OracleReport report;
  std::optional<verify::WrongPlace> wrong;
  double area;           // of the result
  double area_may_move;  // bound times length of all edges of the operands
};

std::string to_text(const Judgement& j, bool overlay) {
  const verify::OracleReport& report = j.report;
  if (j.wrong) {
    std::string text = fmt::format("wrong: at {} {}\n  there: {} A", verify::to_text(j.wrong->at), j.wrong->what,
                                   j.wrong->in_a ? "inside" : "outside of");
    if (overlay) text += fmt::format(", {} B", j.wrong->in_b ? "inside" : "outside of");
    return text + "\n";
  }
  std::uint64_t judged = 0;
  for (const auto& count : report.points) judged += count.certain + count.within_bound;
  std::string text = fmt::format("right: no wrong place at {} and along {}\n", counted(judged, "point"),
                                 counted(report.lines, "line"));
  text += fmt::format("  {:24}{:>14}{:>18}{:>20}\n", "points", "certain", "within the bound", "too near to judge");
  for (int k = 0; k < verify::probe_kinds; ++k) {
    const auto& count = report.points[k];
    text += fmt::format("  {:24}{:>14}{:>18}{:>20}\n", kind_names[k], grouped(count.certain),
                        grouped(count.within_bound), grouped(count.too_near));
  }
  text += fmt::format("  lines: {} stretches between edges, all judged\n", grouped(report.stretches));
  text += fmt::format("  bound: {:.3g}; largest displacement of a tested vertex: {:.3g} ({:.2f} ulps)\n", report.bound,
                      report.largest_displacement, report.largest_displacement_ulps);
  return text + fmt::format("  area: {}, an exact sum rounded once; moved edges may change it by {:.3g}\n", j.area,
                            j.area_may_move);
}

nlohmann::ordered_json to_json(const Judgement& j) {
  const verify::OracleReport& report = j.report;
  nlohmann::ordered_json points;
  for (int k = 0; k < verify::probe_kinds; ++k) {
    const auto& count = report.points[k];
    points[kind_names[k]] = {
        {"certain", count.certain}, {"within_bound", count.within_bound}, {"too_near", count.too_near}};
  }
  nlohmann::ordered_json object{{"right", !j.wrong},
                                {"points", points},
                                {"lines", report.lines},
                                {"stretches", report.stretches},
                                {"bound", report.bound},
                                {"largest_displacement", report.largest_displacement},
                                {"largest_displacement_ulps", report.largest_displacement_ulps},
                                {"area", j.area},
                                {"area_may_move", j.area_may_move}};
  if (j.wrong) {
    object["wrong"] = {{"what", j.wrong->what},
                       {"at", {j.wrong->at.x, j.wrong->at.y}},
                       {"in_a", j.wrong->in_a},
                       {"in_b", j.wrong->in_b}};
  }
  return object;
}

}  // namespace

void add_against_options(CLI::App& command, AgainstArguments& arguments) {
  AgainstArguments* const a = &arguments;
  command.add_option("--against", a->operands, "also check that FILE is the result of these operands")
      ->expected(1, -1)
      ->type_name("IN");
  const auto parsed = [&](const char* option, const char* type, const char* what, auto take) {
    return command.add_option_function<std::string>(option, take, what)->type_name(type)->needs("--against");
  };
  parsed("--op", "OP", "as `oblast overlay`: intersection, union, difference or symdifference of A and B",
         [a](const std::string& word) { a->operation = parse_operation(word); });
  parsed("--fill", "RULE", "the fill rule with which FILE was made",
         [a](const std::string& word) { a->fill = parse_fill(word); });
  parsed("--fill-b", "RULE", "the fill rule of B, if it is not that of A",
         [a](const std::string& word) { a->fill_b = parse_fill(word); });
  command.add_option("--points", a->points, "number of points to test (200000)")
      ->check(CLI::Range(std::uint64_t{10}, std::uint64_t{1'000'000'000}))
      ->type_name("N")
      ->needs("--against");
  command.add_option("--lines", a->lines, "number of lines to test (1000)")
      ->check(CLI::Range(0U, 1'000'000U))
      ->type_name("N")
      ->needs("--against");
  command.add_option("--seed", a->seed, "seed of the random points and lines (1)")->type_name("N")->needs("--against");
  command.add_option("--threads", a->threads, "number of threads; 0 (default): all cores. The findings are the same")
      ->check(CLI::Range(0, 1024))
      ->type_name("N");
}

void check_call(const std::string& file, const AgainstArguments& arguments) {
  const std::size_t operands = arguments.operands.size();
  if (arguments.operation && *arguments.operation != Operation::unite && operands != 2) {
    throw CallError(fmt::format("--op {} needs two operands: --against A B; there {} {}", name(*arguments.operation),
                                operands == 1 ? "is" : "are", operands));
  }
  if (arguments.fill_b && !is_overlay(arguments)) throw CallError("--fill-b needs two operands and --op");
  const auto from_standard_input = std::count(arguments.operands.begin(), arguments.operands.end(), "-");
  if (from_standard_input + (file == "-" ? 1 : 0) > 1) throw CallError("standard input (-) can be named only once");
}

AgainstFindings check_against(const io::Layer& result, const AgainstArguments& arguments, const InputArguments& input) {
  const bool overlay = is_overlay(arguments);
  const Operation operation = arguments.operation.value_or(Operation::unite);
  std::vector<std::string> first = arguments.operands;
  if (overlay) first.resize(1);
  const io::Layer a = read_operand(first, result, arguments.threads, input);
  io::Layer b;
  if (overlay) b = read_operand({arguments.operands[1]}, result, arguments.threads, input);

  verify::OracleOptions options;
  options.fill_a = arguments.fill;
  options.fill_b = arguments.fill_b.value_or(arguments.fill);
  options.points = arguments.points;
  options.lines = arguments.lines;
  options.seed = arguments.seed;
  options.threads = arguments.threads;
  Judgement judgement;
  judgement.wrong =
      verify::look_for_wrong_place(a.regions, b.regions, operation, result.regions, options, &judgement.report);
  judgement.area = verify::round_to_nearest(verify::exact_area_of(result.regions));
  judgement.area_may_move =
      judgement.report.bound * (verify::length_of_edges(a.regions) + verify::length_of_edges(b.regions));
  return {!judgement.wrong, to_text(judgement, overlay), to_json(judgement)};
}

}  // namespace oblast::app
