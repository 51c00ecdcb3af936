// The point sets that broke the Voronoi diagrams of others (../shared/zones), each judged by verify/: the cells of an
// exact diagram, vertex by vertex, coverage, and the nearest point.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "zones/zone_trial.h"

namespace oblast::testing {
namespace {

/// The points of a text such as "MULTIPOINT ((1 2), (3 4))".
std::vector<Point> points_of(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
  std::istringstream numbers(text);
  std::string kind;
  numbers >> kind;
  std::vector<Point> points;
  for (Point p; numbers >> p.x >> p.y;) points.push_back(p);
  return points;
}

TEST(ZonesCorpus, Points) {
  std::ifstream file(OBLAST_SHARED "/zones/points.jsonl");
  ASSERT_TRUE(file) << "no point sets";
  int cases = 0;
  for (std::string line; std::getline(file, line); ++cases) {
    const nlohmann::json c = nlohmann::json::parse(line);
    ZoneQuestion question;
    question.points = points_of(c["points"]);
    ASSERT_FALSE(question.points.empty()) << c["id"];
    const auto failure = run_zone_trial(question, {4, 2000, true});
    EXPECT_FALSE(failure) << c["id"] << ": " << to_text(failure->broken) << ": " << failure->what << "\n  "
                          << c["points"];
  }
  EXPECT_GE(cases, 38);
}

}  // namespace
}  // namespace oblast::testing
