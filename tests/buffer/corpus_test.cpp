// The buffer cases of JTS, GEOS, Boost.Geometry and Clipper2, and those of known bugs (../shared/buffers). Each result
// is judged by verify/, and its area is compared with what the source states, or else with the references of the
// corpus. tests/buffer/excused.txt lists the cases whose expectation we do not meet, each with a reason; verify/ judges
// them, too.
#include <gtest/gtest.h>
#include <oblast/measure.h>
#include <oblast/overlay.h>

#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "buffer/buffer_trial.h"
#include "buffer/wkt_shapes.h"
#include "verify/buffer_zone.h"
#include "verify/verify.h"

namespace oblast::testing {
namespace {

using nlohmann::json;

std::map<std::string, std::string> excused() {
  std::map<std::string, std::string> reasons;
  std::ifstream file(OBLAST_SOURCE_DIR "/tests/buffer/excused.txt");
  for (std::string line; std::getline(file, line);) {
    const std::size_t tab = line.find('\t');
    if (!line.empty() && line[0] != '#' && tab != std::string::npos)
      reasons[line.substr(0, tab)] = line.substr(tab + 1);
  }
  return reasons;
}

BufferOptions options_of(const json& c) {
  BufferOptions options;
  const std::string join = c["join"], cap = c["cap"], side = c["side"], source = c["source"];
  options.join = join == "mitre" ? Join::mitre : join == "bevel" ? Join::bevel : Join::round;
  options.cap = cap == "flat" ? Cap::flat : cap == "square" ? Cap::square : Cap::round;
  options.side = side == "left" ? Side::left : side == "right" ? Side::right : Side::both;
  if (c.contains("mitre_limit") && c["mitre_limit"].is_number())
    options.mitre_limit = std::max(1.0, c["mitre_limit"].get<double>());
  options.tolerance = 1e-5;
  return options;
}

double perimeter(const RegionView& regions) {
  double sum = 0;
  for (const std::span<const Point> contour : regions.contours())
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Point p = contour[i], q = contour[(i + 1) % contour.size()];
      sum += std::hypot(q.x - p.x, q.y - p.y);
    }
  return sum;
}

/// The first thing that is wrong, or empty.
std::string fault_of(const json& c, bool is_compared) {
  BufferQuestion question{shapes_from_wkt(c["geometry"]), c["distance"], options_of(c)};
  BufferStatistics statistics;
  question.options.statistics = &statistics;
  const RegionSet zone = buffer(question.shapes.view(), question.distance, question.options);
  if (const auto fault = verify::check_result(zone)) return "not closed: " + fault->what;
  question.options.statistics = nullptr;
  // Bounds by verify/, at a usual tolerance, where its cost of n m allows.
  question.options.tolerance = 0.01;
  if (zone.points.size() * (question.shapes.regions.points.size() + question.shapes.line_points.size()) < 100'000'000)
    if (const auto failure = run_buffer_trial(question, 1))
      return std::string(to_text(failure->broken)) + ": " + failure->what;

  if (!is_compared) return {};
  const json& expect = c["expect"];
  const double found = area(zone);
  std::ostringstream wrong;
  wrong.precision(12);
  if (expect.value("empty", false) != zone.empty() && expect.contains("empty"))
    wrong << "empty " << zone.empty() << " but " << expect["empty"] << " expected; ";
  if (expect.contains("area") && expect["area"].is_number()) {
    const double stated = expect["area"], tolerance = expect.value("area_tol", 0.0);
    // Sources draw arcs with few segments: a circle of n segments lacks 1 - sin(2 pi / n) n / (2 pi) of its area.
    if (std::fabs(found - stated) > tolerance + 0.02 * std::fabs(stated))
      wrong << "area " << found << " but " << stated << " expected; ";
  }
  const json& ref = c["ref"];
  if (ref.is_object()) {
    double nearest = 1e300;
    std::string references;
    for (const char* name : {"area", "area_pieces", "area_pieces_evenodd"})
      if (ref.contains(name) && ref[name].is_number()) {
        const double reference = ref[name];
        references += std::string(" ") + name + " " + ref[name].dump();
        // What little is left of a shrunk region depends on the tolerance of the arcs.
        const double arcs = 3e-5 * std::fabs(question.distance) * perimeter(zone);
        nearest = std::min(nearest, std::max(0.0, std::fabs(found - reference) - arcs) /
                                        std::max({std::fabs(reference), found, 1e-300}));
      }
    if (nearest < 1e300 && nearest > 2e-3) wrong << "area " << found << " but references" << references << "; ";
  }
  return wrong.str();
}

void run_source(const std::string& source) {
  std::ifstream file(OBLAST_SHARED "/buffers/" + source + "/cases.jsonl");
  ASSERT_TRUE(file) << "no cases of " << source;
  const std::map<std::string, std::string> reasons = excused();
  int cases = 0, excuses = 0;
  for (std::string line; std::getline(file, line); ++cases) {
    const json c = json::parse(line);
    const std::string id = c["id"];
    if (c.contains("distance_right")) {  // a width for each side: we have one
      ++excuses;
      continue;
    }
    const auto reason = reasons.find(id);
    const bool is_excused = reason != reasons.end();
    excuses += is_excused;
    if (is_excused && reason->second.starts_with("a coordinate beyond")) {
      EXPECT_THROW(fault_of(c, false), Error) << id;
      continue;
    }
    std::string fault;
    try {
      fault = fault_of(c, !is_excused);
    } catch (const std::exception& e) {
      fault = std::string("threw: ") + e.what();
    }
    EXPECT_EQ(fault, "") << id << " distance " << c["distance"] << ' ' << c["join"] << ' ' << c["cap"] << ' '
                         << c["side"] << ' ' << c.value("note", "");
  }
  std::printf("%s: %d cases, %d excused\n", source.c_str(), cases, excuses);
}

TEST(BufferCorpus, Issues) { run_source("issues"); }
TEST(BufferCorpus, Jts) { run_source("jts"); }
TEST(BufferCorpus, Geos) { run_source("geos"); }
TEST(BufferCorpus, Clipper2) { run_source("clipper2"); }
TEST(BufferCorpus, BoostGeometry) { run_source("boost-geometry"); }

}  // namespace
}  // namespace oblast::testing
