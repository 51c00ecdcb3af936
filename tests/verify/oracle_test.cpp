// The oracle finds each kind of wrong answer, and lets right ones pass.
#include "verify/oracle.h"

#include <gtest/gtest.h>
#include <oblast/oblast.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "generators/hostile.h"
#include "generators/request.h"
#include "verify/against.h"
#include "verify/exact_sum.h"
#include "verify/slabs.h"
#include "verify/sources.h"
#include "verify/text_regions.h"

namespace oblast::verify {
namespace {

constexpr Operation operations[] = {Operation::intersection, Operation::unite, Operation::difference,
                                    Operation::symmetric_difference};

OracleOptions few(std::uint64_t points = 2'000, std::uint32_t lines = 40) {
  OracleOptions options;
  options.points = points;
  options.lines = lines;
  options.threads = 1;
  return options;
}

// The message of the oracle for a result; "" if it finds no fault.
struct Asked {
  RegionSet a, b;
  Operation operation = Operation::unite;

  std::string of(const RegionSet& result, const OracleOptions& options = few()) const {
    const auto wrong = look_for_wrong_place(a, b, operation, result, options);
    return wrong ? wrong->what : "";
  }
  RegionSet right() const { return overlay(a, b, operation); }
};

const std::string square = "0 0, 4 0, 4 4, 0 4";
const std::string shifted = "2 2, 6 2, 6 6, 2 6";

TEST(Oracle, LetsRightAnswersPass) {
  const RegionSet a = regions_of(square), b = regions_of(shifted);
  for (const Operation operation : operations) {
    const Asked asked{a, b, operation};
    OracleReport report;
    EXPECT_FALSE(look_for_wrong_place(a, b, operation, asked.right(), few(), &report));
    for (const auto& count : report.points) EXPECT_GT(count.certain + count.within_bound, 0u);
    EXPECT_EQ(report.lines, 40u);
    EXPECT_GT(report.stretches, 40u);
    EXPECT_EQ(report.bound, 4 * 0x1p-50);
  }
  EXPECT_EQ((Asked{{}, {}, Operation::unite}.of({})), "");
}

TEST(Oracle, FindsTheAnswerToAnotherQuestion) {
  const RegionSet a = regions_of(square), b = regions_of(shifted);
  for (const Operation asked : operations) {
    for (const Operation answered : operations) {
      if (asked == answered) continue;
      const RegionSet result = overlay(a, b, answered);
      EXPECT_NE((Asked{a, b, asked}.of(result)), "");
      // Points and lines each find it alone.
      EXPECT_NE((Asked{a, b, asked}.of(result, few(2'000, 0))), "");
      EXPECT_NE((Asked{a, b, asked}.of(result, few(0, 40))), "");
    }
  }
  EXPECT_NE((Asked{a, b, Operation::unite}.of({})), "");
  EXPECT_NE((Asked{{}, {}, Operation::unite}.of(a)), "");
}

TEST(Oracle, ReadsFillRules) {
  const RegionSet layer = regions_of("0 0, 4 0, 4 4, 0 4 | 2 2, 2 6, 6 6, 6 2");
  const FillRule rules[] = {FillRule::polygons(), FillRule::at_least(2), FillRule::even_odd(),
                            FillRule::nonzero(),  FillRule::positive(),  FillRule::negative()};
  for (const FillRule& asked : rules) {
    for (const FillRule& answered : rules) {
      Options options;
      options.fill_a = answered;
      OracleOptions question = few();
      question.fill_a = asked;
      const RegionSet result = unite(layer, options);
      Options right;
      right.fill_a = asked;
      EXPECT_EQ((Asked{layer, {}}.of(result, question).empty()), result == unite(layer, right));
    }
  }
}

// A rotated square on another one, whose crossings are not doubles, and a hole outside both.
Asked thirds() {
  return {regions_of("0 0, 10 0, 10 10, 0 10; 1 1, 1 3, 3 3, 3 1"), regions_of("5 -1, 11.1 5.3, 4.7 11.9, 3.3 4.9"),
          Operation::unite};
}

void expect_found(const Asked& asked, const std::function<void(RegionSet&)>& change) {
  RegionSet result = asked.right();
  ASSERT_EQ(asked.of(result), "");
  change(result);
  EXPECT_NE(asked.of(result), "");
}

std::size_t some_crossing(const Asked& asked, const RegionSet& result) {
  for (std::size_t v = 0; v < result.points.size(); ++v) {
    const auto is = [&](const Point& p) { return p == result.points[v]; };
    if (std::none_of(asked.a.points.begin(), asked.a.points.end(), is) &&
        std::none_of(asked.b.points.begin(), asked.b.points.end(), is)) {
      return v;
    }
  }
  ADD_FAILURE() << "no crossing";
  return 0;
}

TEST(Oracle, FindsACrossingMovedByFiftyUlps) {
  const Asked asked = thirds();
  for (const double sign : {-1.0, 1.0}) {
    expect_found(asked, [&](RegionSet& r) { r.points[some_crossing(asked, r)].x += sign * 50 * 0x1p-49; });
    expect_found(asked, [&](RegionSet& r) { r.points[some_crossing(asked, r)].y += sign * 50 * 0x1p-49; });
  }
}

TEST(Oracle, FindsAnyVertexMovedByABillionth) {
  const Asked asked = thirds();
  for (std::size_t v = 0; v < asked.right().points.size(); ++v) {
    expect_found(asked, [&](RegionSet& r) { r.points[v].x += 1e-8; });
    expect_found(asked, [&](RegionSet& r) { r.points[v].y -= 1e-8; });
  }
}

TEST(Oracle, FindsAHoleThatIsMissing) {
  expect_found(thirds(), [](RegionSet& r) {
    ASSERT_GE(r.contour_ends.size(), 2u);
    r.points.resize(r.contour_ends[r.contour_ends.size() - 2]);
    r.contour_ends.pop_back();
    --r.polygon_ends.back();
  });
}

TEST(Oracle, FindsAPolygonThatIsMissing) {
  const Asked asked{regions_of("0 0, 1 0, 1 1, 0 1 | 5 0, 6 0, 6 1, 5 1 | 9 9, 10 9, 10 10, 9 10"), {}};
  for (std::size_t missing = 0; missing < 3; ++missing) {
    expect_found(asked, [&](RegionSet& r) {
      ASSERT_EQ(r.contour_ends.size(), 3u);
      r.points.erase(r.points.begin() + 4 * static_cast<std::ptrdiff_t>(missing),
                     r.points.begin() + 4 * static_cast<std::ptrdiff_t>(missing + 1));
      r.contour_ends = {4, 8};
      r.polygon_ends = {1, 2};
    });
  }
}

TEST(Oracle, FindsContoursTurnedOrGivenTwice) {
  expect_found(thirds(), [](RegionSet& r) { std::reverse(r.points.begin(), r.points.end()); });
  expect_found(thirds(), [](RegionSet& r) {
    const std::vector<Point> once = r.points;
    const std::vector<std::uint32_t> ends = r.contour_ends;
    r.points.insert(r.points.end(), once.begin(), once.end());
    for (const std::uint32_t end : ends) r.contour_ends.push_back(end + static_cast<std::uint32_t>(once.size()));
    r.polygon_ends.push_back(2 * r.polygon_ends.back());
  });
}

TEST(Oracle, FindsAVertexLeftOut) {
  const Asked asked = thirds();
  for (std::size_t v = 0; v < asked.right().points.size(); ++v) {
    expect_found(asked, [&](RegionSet& r) {
      r.points.erase(r.points.begin() + static_cast<std::ptrdiff_t>(v));
      for (std::uint32_t& end : r.contour_ends) end -= end > v ? 1 : 0;
    });
  }
}

TEST(Oracle, FindsAnEdgeThatNoInputEdgeIsNear) {
  // A square that is inside already: membership is right everywhere, were it not for a cut through it.
  const Asked asked{regions_of(square), {}};
  const RegionSet cut = regions_of("0 0, 4 0, 4 2, 0 2 | 0 2, 4 2, 4 4, 0 4");
  EXPECT_NE(asked.of(cut, few(2'000, 0)), "");
  EXPECT_NE(asked.of(cut, few(0, 40)), "");
}

RegionSet star(int n, double turn, unsigned seed) {
  std::mt19937 random(seed);
  RegionSet result;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    const double radius = 1000 * (1 + 0.2 * std::sin(5 * (angle + turn)) + 1e-5 * static_cast<double>(random() % 100));
    result.points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  result.contour_ends = {static_cast<std::uint32_t>(n)};
  result.polygon_ends = {1};
  return result;
}

// Crossings that are no doubles lie beside their edges: a bound that allows for less than rounding finds that.
TEST(Oracle, SeesRoundingWhereTheBoundDoesNotAllowIt) {
  const Asked asked{regions_of("0 0.3, 10.1 0, 9.7 10, -0.3 9.9"), regions_of("5 -1, 11.1 5.3, 4.7 11.9, 3.3 4.9"),
                    Operation::unite};
  OracleOptions options = few();
  options.bound_ulps = 1e-3;
  EXPECT_NE(asked.of(asked.right(), options), "");
  OracleReport report;
  EXPECT_FALSE(look_for_wrong_place(asked.a, asked.b, asked.operation, asked.right(), few(), &report));
  EXPECT_GT(report.largest_displacement_ulps, 1e-3);
  EXPECT_LT(report.largest_displacement_ulps, 1);
}

TEST(Crossings, AreFoundInASeaOfEdges) {
  // Two stars of 20,000 edges each that cross some ten times, and a net of 60 bars that cross 3,600 times.
  const RegionSet a = star(20'000, 0, 1), b = star(20'000, 0.3, 2);
  std::mt19937_64 random(1);
  EXPECT_GE(some_crossings(Segments(a, b, {}), 1'000, random).size(), 8u);
  RegionSet net;
  for (int i = 0; i < 30; ++i) {
    for (const bool upright : {false, true}) {
      for (const Point& p : {Point{0, 0}, Point{100, 0}, Point{100, 1}, Point{0, 1}}) {
        const double x = p.x, y = 3 * i + p.y;
        net.points.push_back(upright ? Point{y, x} : Point{x, y});
      }
      net.contour_ends.push_back(static_cast<std::uint32_t>(net.points.size()));
    }
  }
  const std::vector<Point> found = some_crossings(Segments(net, {}, {}), 50, random);
  EXPECT_EQ(found.size(), 50u);
  for (const Point& p : found) {
    for (const double coordinate : {p.x, p.y}) {
      EXPECT_NEAR(coordinate, std::round(coordinate), 1e-9);
      EXPECT_NE(std::fmod(std::round(coordinate), 3), 2);  // bars lie at 0 to 1, 3 to 4, 6 to 7, ...
    }
  }
}

TEST(Oracle, HostileResultsAreRight) {
  std::uint64_t judged = 0;
  for (const auto& generator : generators::hostile_generators()) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const auto [a, b] = generator.make(seed, generator.usual);
      const Options options = generators::options_of(generators::draw_request(seed));
      OracleOptions question = few(500, 20);
      question.fill_a = options.fill_a;
      question.fill_b = options.fill_b;
      question.seed = seed;
      for (const Operation operation : operations) {
        OracleReport report;
        const auto wrong = look_for_wrong_place(a, b, operation, overlay(a, b, operation, options), question, &report);
        EXPECT_FALSE(wrong) << generator.name << " seed " << seed << ": " << wrong->what;
        for (const auto& count : report.points) judged += count.certain + count.within_bound;
      }
    }
  }
  // Of some 450,000 points; where everything coincides many are too near.
  EXPECT_GT(judged, 200'000u);
}

// Contours dropped or doubled, vertices moved or left out.
void mutate(RegionSet& r, std::mt19937& random) {
  const std::size_t v = random() % r.points.size();
  Point& p = r.points[v];
  const auto contour = static_cast<std::size_t>(std::upper_bound(r.contour_ends.begin(), r.contour_ends.end(), v) -
                                                r.contour_ends.begin());
  const std::size_t begin = contour == 0 ? 0 : r.contour_ends[contour - 1];
  switch (random() % 4) {
    case 0:
      p.x += 0.01 * (std::abs(p.x) + 1e-3);
      break;
    case 1:
      p.y -= 1e-6 * std::abs(p.y);
      break;
    case 2:
      r.points.erase(r.points.begin() + static_cast<std::ptrdiff_t>(v));
      for (std::size_t c = contour; c < r.contour_ends.size(); ++c) --r.contour_ends[c];
      break;
    case 3:
      std::reverse(r.points.begin() + static_cast<std::ptrdiff_t>(begin),
                   r.points.begin() + static_cast<std::ptrdiff_t>(r.contour_ends[contour]));
      break;
  }
}

// Whether a whole trapezoid of the exact arrangement, its centre further than the bound from every input edge, is
// inside the result and should not be, or the reverse.
bool wrong_by_trapezoids(const RegionSet& a, const RegionSet& b, Operation operation, const RegionSet& result) {
  const Sources sources(a, b, {}, 4);
  bool wrong = false;
  const std::vector<Operand> operands{
      {a, FillRule::polygons()}, {b, FillRule::polygons()}, {result, FillRule::even_odd()}};
  for_each_trapezoid(operands, [&](const Trapezoid& t) {
    if (selects(operation, t.inside[0], t.inside[1]) != t.inside[2]) wrong = wrong || !sources.near_any(t);
  });
  return wrong;
}

// Rationals see everything, on small inputs. Where they see a wrong place, the oracle is to see one too, nearly always;
// where the oracle sees one, check_closed or check_against must have seen some fault.
TEST(Oracle, AgreesWithCheckAgainstOnMutatedResults) {
  std::mt19937 random(7);
  int mutated = 0, wrong_places = 0, found = 0, by_oracle_alone = 0;
  for (const auto& generator : generators::hostile_generators()) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const auto [a, b] = generator.make(seed, 16);
      const Operation operation = operations[seed % 4];
      RegionSet result = overlay(a, b, operation);
      if (result.points.size() < 4 || result.points.size() > 60) continue;
      mutate(result, random);
      ++mutated;
      const bool oracle = !Asked{a, b, operation}.of(result, few(4'000, 60)).empty();
      auto fault = check_closed(result);
      if (!fault) fault = check_against(a, b, operation, {}, result);
      const bool wrong_place = wrong_by_trapezoids(a, b, operation, result);
      wrong_places += wrong_place;
      found += wrong_place && oracle;
      by_oracle_alone += oracle && !fault;
    }
  }
  RecordProperty("mutated", mutated);
  RecordProperty("wrong_places", wrong_places);
  RecordProperty("found", found);
  EXPECT_GT(mutated, 60);
  EXPECT_GT(wrong_places, 40);
  EXPECT_GE(found * 20, wrong_places * 19) << found << " of " << wrong_places;
  EXPECT_EQ(by_oracle_alone, 0);
}

TEST(Oracle, LargeResults) {
  const Asked asked{star(60'000, 0, 1), star(60'000, 0.3, 2), Operation::symmetric_difference};
  RegionSet result = asked.right();
  EXPECT_EQ(asked.of(result, few(100'000, 200)), "");
  // The largest polygon is missing, of some ten without holes.
  ASSERT_EQ(result.polygon_ends.size(), result.contour_ends.size());
  std::uint32_t first = 0, last = 0, begin = 0;
  for (const std::uint32_t end : result.contour_ends) {
    if (end - begin > last - first) first = begin, last = end;
    begin = end;
  }
  result.points.erase(result.points.begin() + first, result.points.begin() + last);
  std::erase(result.contour_ends, last);
  for (std::uint32_t& end : result.contour_ends) end -= end > last ? last - first : 0;
  result.polygon_ends.pop_back();
  EXPECT_NE(asked.of(result, few(20'000, 0)), "");
  EXPECT_NE(asked.of(result, few(0, 200)), "");
}

// Of many small faults one in so many is beside a point: with two points for each edge and more, none is missed.
TEST(Oracle, ManyPointsLeaveNoEdgeOut) {
  RegionSet grid;
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 40; ++j) {
      const double x = 3 * i, y = 3 * j;
      for (const Point& p : {Point{x, y}, Point{x + 1, y}, Point{x + 1, y + 1}, Point{x, y + 1}}) {
        grid.points.push_back(p);
      }
      grid.contour_ends.push_back(static_cast<std::uint32_t>(grid.points.size()));
      grid.polygon_ends.push_back(static_cast<std::uint32_t>(grid.contour_ends.size()));
    }
  }
  const Asked asked{grid, {}, Operation::unite};
  std::mt19937 random(3);
  for (int trial = 0; trial < 20; ++trial) {
    RegionSet result = unite(grid);
    result.points[random() % result.points.size()].x += 1e-9;
    EXPECT_NE(asked.of(result, few(100'000, 0)), "") << trial;
  }
}

TEST(Oracle, ThreadsMakeNoDifference) {
  const Asked asked{star(3'000, 0, 1), star(3'000, 0.3, 2), Operation::intersection};
  RegionSet result = asked.right();
  const auto look = [&](int threads, OracleReport& report) {
    OracleOptions options = few(20'000, 100);
    options.threads = threads;
    return look_for_wrong_place(asked.a, asked.b, asked.operation, result, options, &report);
  };
  OracleReport one, three;
  EXPECT_FALSE(look(1, one));
  EXPECT_FALSE(look(3, three));
  for (int k = 0; k < probe_kinds; ++k) {
    EXPECT_EQ(one.points[k].certain, three.points[k].certain);
    EXPECT_EQ(one.points[k].within_bound, three.points[k].within_bound);
    EXPECT_EQ(one.points[k].too_near, three.points[k].too_near);
  }
  EXPECT_EQ(one.stretches, three.stretches);
  result.points[100].x += 1;
  const auto first = look(1, one), same = look(3, three);
  ASSERT_TRUE(first && same);
  EXPECT_EQ(first->at, same->at);
}

TEST(ExactSum, AreasAsByRationals) {
  for (const auto& generator : generators::hostile_generators()) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const RegionSet regions = generator.make(seed, 40).a;
      EXPECT_EQ(exact_area_of(regions), exact_signed_area(regions)) << generator.name;
    }
  }
  // The ends of the domain, and what cancels to the last bit.
  const double huge = 0x1p300, tiny = 0x1p-300;
  for (const RegionSet& r : {RegionSet{{{0, 0}, {huge, 0}, {huge, huge}, {0, huge}}, {4}, {1}},
                             RegionSet{{{0, 0}, {tiny, 0}, {tiny, tiny}, {0, tiny}}, {4}, {1}},
                             RegionSet{{{-huge, tiny}, {huge, -tiny}, {tiny, huge}}, {3}, {1}}}) {
    EXPECT_EQ(exact_area_of(r), exact_signed_area(r));
    EXPECT_NE(exact_area_of(r), 0);
  }
}

}  // namespace
}  // namespace oblast::verify
