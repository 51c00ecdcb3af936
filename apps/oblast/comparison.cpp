#include "oblast/comparison.h"

#include <fmt/format.h>
#include <oblast/overlay.h>

#include <algorithm>
#include <chrono>

#include "oblast/console.h"

namespace oblast::app {

namespace {

constexpr double enough_seconds = 0.3;
constexpr int most_runs = 20;

RegionSet run_once(const Method& method, const OperandPair& pair, Operation operation, const CallOptions& call,
                   Row& row) {
  if (!method.classic) {
    Statistics statistics;
    Options options;
    static_cast<CallOptions&>(options) = call;
    options.engine = method.engine;
    options.statistics = &statistics;  // excludes the fast paths of `overlay`: the engine itself is measured
    return overlay(pair.a.regions, pair.b.regions, operation, options);
  }
  ClassicReport report;
  RegionSet result = classic(*method.classic, pair.a.regions, pair.b.regions, operation, &report, call);
  row.handed_over = report.handed_over;
  return result;
}

}  // namespace

std::vector<Row> compare_methods(const OperandPair& pair, Operation operation, const CallOptions& call) {
  std::vector<Row> rows;
  for (const Method& method : methods()) {
    Row& row = rows.emplace_back();
    row.method = &method;
    try {
      double total = 0;
      for (int run = 0; run < most_runs && total < enough_seconds; ++run) {
        const auto begin = std::chrono::steady_clock::now();
        row.result = run_once(method, pair, operation, call, row);
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
        row.seconds = run == 0 ? spent.count() : std::min(row.seconds, spent.count());
        total += spent.count();
      }
      row.admitted = true;
      row.same_bytes = row.result == rows.front().result;
    } catch (const Error& error) {
      if (error.code() != ErrorCode::precondition) throw io::IoError(describe(pair, error));
      row.why_not = error.what();
    }
  }
  return rows;
}

std::string to_text(const std::vector<Row>& rows) {
  std::string text = fmt::format("{:<25} {:<26} {:>8} {:>6}  {:<28} {:<7} {:>11} {:>9} {:>10} {:>16}  {}\n", "method",
                                 "accepts (Table 1)", "contours", "robust", "worst", "average", "seconds", "contours",
                                 "vertices", "area", "same bytes");
  for (const Row& row : rows) {
    const Method& m = *row.method;
    text += fmt::format("{:<25} {:<26} {:>8} {:>6}  {:<28} {:<7} ", std::string(m.title) + (m.in_table ? "" : " *"),
                        m.operands, m.contours, m.robust, m.worst, m.average);
    if (row.admitted)
      text += fmt::format("{:>11.7f} {:>9} {:>10} {:>16.10g}  {}{}\n", row.seconds, row.result.contour_ends.size(),
                          row.result.points.size(), signed_area(row.result), row.same_bytes ? "yes" : "NO",
                          row.handed_over ? ", by settled noding" : "");
    else
      text += "does not accept this input\n";
  }
  text +=
      "\nseconds, contours, vertices and area are measured. The columns before them are from Skvortsov's Table 1\n"
      "(*: not in Table 1; our own entry). n1, n2: vertices of A and B; n = n1 + n2 + meetings; k: meetings.\n";
  for (const Row& row : rows)
    if (!row.admitted) text += fmt::format("\n{}", row.why_not);
  if (text.back() != '\n') text += '\n';
  return text;
}

nlohmann::ordered_json to_json(const std::vector<Row>& rows) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Row& row : rows) {
    const Method& m = *row.method;
    nlohmann::ordered_json object{{"method", m.word},
                                  {"admits", m.operands},
                                  {"several_contours", m.contours[0] == '+'},
                                  {"robust", m.robust[0] == '+'},
                                  {"worst", m.worst},
                                  {"average", m.average},
                                  {"in_table_1", m.in_table},
                                  {"admitted", row.admitted}};
    if (row.admitted) {
      object["seconds"] = row.seconds;
      object["contours"] = row.result.contour_ends.size();
      object["vertices"] = row.result.points.size();
      object["area"] = signed_area(row.result);
      object["same_bytes"] = row.same_bytes;
      object["handed_over"] = row.handed_over;
    } else {
      object["why_not"] = row.why_not;
    }
    list.push_back(object);
  }
  return list;
}

}  // namespace oblast::app
