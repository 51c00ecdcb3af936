// The classics: by hand at the meetings that break them, at random against `overlay`, and refused outside their
// domains.
#include <gtest/gtest.h>
#include <oblast/classics.h>
#include <oblast/oblast.h>

#include "classics/cases.h"
#include "classics/shapes.h"
#include "classics/trial.h"
#include "classics/wkt.h"
#include "generators/soup.h"

namespace {

using namespace oblast;
using namespace oblast::tests;

constexpr Operation operations[] = {Operation::intersection, Operation::unite, Operation::difference};

/// A case must be in the domain of every method named, and not be handed over.
void expect_like_overlay(const RegionSet& a, const RegionSet& b, std::initializer_list<ClassicMethod> methods) {
  for (const ClassicMethod method : methods)
    for (const Operation operation : operations) {
      if (method == ClassicMethod::sutherland_hodgman && operation != Operation::intersection) continue;
      ClassicReport report;
      EXPECT_EQ(classic(method, a, b, operation, &report), by_pipeline(a, b, operation))
          << name_of(method) << " operation " << static_cast<int>(operation) << "\nA " << wkt(a) << "\nB " << wkt(b);
      EXPECT_FALSE(report.handed_over) << name_of(method) << "\nA " << wkt(a) << "\nB " << wkt(b);
    }
}

constexpr std::initializer_list<ClassicMethod> all = {ClassicMethod::orourke, ClassicMethod::sutherland_hodgman,
                                                      ClassicMethod::weiler_atherton, ClassicMethod::margalit_knott};

TEST(Classics, TwoSquaresInEveryPosition) {
  // Corners, sides and insides of two squares of a grid meet in all ways: 9 x 9 x 16 positions.
  for (int x = -4; x <= 4; ++x)
    for (int y = -4; y <= 4; ++y)
      for (int w = 1; w <= 4; ++w)
        for (int h = 1; h <= 4; ++h) expect_like_overlay(rectangle(0, 0, 4, 4), rectangle(x, y, x + w, y + h), all);
}

TEST(Classics, DiamondTouchesFromInside) {
  const RegionSet diamond = one_contour({{2, 0}, {4, 2}, {2, 4}, {0, 2}});
  expect_like_overlay(rectangle(0, 0, 4, 4), diamond, all);
  expect_like_overlay(diamond, rectangle(0, 0, 4, 4), all);
}

TEST(Classics, OneVertexTouchesFromInside) {
  expect_like_overlay(rectangle(0, 0, 4, 4), one_contour({{2, 0}, {3, 2}, {1, 2}}), all);
}

TEST(Classics, BridgesOfTheHalfPlaneClip) {
  // A comb whose teeth reach out of the window: joined in the order of the walk, its parts would be
  // connected by edges there and back along the window's side.
  const RegionSet comb =
      one_contour({{0, 0}, {9, 0}, {9, 6}, {8, 6}, {8, 2}, {6, 2}, {6, 6}, {5, 6}, {5, 2}, {3, 2}, {3, 6}, {0, 6}});
  const RegionSet window = rectangle(-1, 3, 10, 5);
  const RegionSet clipped = sutherland_hodgman(comb, window);
  EXPECT_EQ(clipped.polygon_ends.size(), 3u);
  expect_like_overlay(
      comb, window, {ClassicMethod::sutherland_hodgman, ClassicMethod::weiler_atherton, ClassicMethod::margalit_knott});
}

TEST(Classics, VerticesOfBothStayOnTheBoundary) {
  // Straight vertices of the window, vertices of a hole that touches it from outside, a side shared in part.
  RegionSet a = rectangle(0, 0, 10, 10);
  generators::add_hole(a, {{4, 5}, {6, 5}, {5, 8}});
  const RegionSet b = one_contour({{2, 0}, {3, 0}, {8, 0}, {8, 5}, {7, 5}, {2, 5}});
  expect_like_overlay(a, b, {ClassicMethod::sutherland_hodgman});
  RegionSet directed = overlay(a, RegionSet{}, Operation::unite);
  expect_like_overlay(directed, b, {ClassicMethod::weiler_atherton});
}

TEST(Classics, KeyholeIsVertexComplete) {
  // A ring drawn as one contour with a bridge to its hole: the bridge is walked there and back.
  const RegionSet keyhole =
      one_contour({{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 0}, {2, 2}, {2, 6}, {6, 6}, {6, 2}, {2, 2}});
  expect_like_overlay(keyhole, rectangle(1, 1, 4, 9), {ClassicMethod::margalit_knott});
  expect_like_overlay(rectangle(1, 1, 4, 9), keyhole, {ClassicMethod::margalit_knott});
}

TEST(Classics, OrientationMayBeEitherWay) {
  const RegionSet ccw = rectangle(0, 0, 4, 4), cw = one_contour({{2, 6}, {6, 6}, {6, 2}, {2, 2}});
  expect_like_overlay(ccw, cw, all);
  expect_like_overlay(cw, ccw, all);
}

TEST(Classics, SliverWhoseRoundedAreaHasTheOtherSign) {
  // Counter-clockwise by half a unit in the last place; a fuzzer took its rounded area for its direction.
  const RegionSet sliver = one_contour({{0.1, 0.1}, {0.2, 0.3}, {0.8, 1.5}});
  EXPECT_LT(signed_area(sliver), 0);
  for (const RegionSet& other : {rectangle(0, 0, 1, 1), rectangle(5, 5, 6, 6)})
    for (const Operation operation : operations) {
      const ClassicCase c{sliver, other, operation};
      EXPECT_EQ(weiler_atherton(c.a, c.b, operation), expected(ClassicMethod::weiler_atherton, c));
    }
  EXPECT_FALSE(weiler_atherton(sliver, rectangle(0, 0, 1, 1), Operation::intersection).empty());
}

TEST(Classics, RandomCasesInsideAndOutside) {
  for (const ClassicMethod method : all_methods) {
    const TrialCount count = run_trial(method, 3000, 500, 42);
    EXPECT_EQ(count.wrong, 0) << name_of(method) << ": " << count.first_failure;
    EXPECT_EQ(count.admitted, 0) << name_of(method) << ": " << count.first_failure;
    EXPECT_EQ(count.handed_over[static_cast<int>(Spread::reals)], 0) << "handing over is for near meetings only";
    EXPECT_GT(count.meeting, 500);
  }
}

TEST(Classics, AdvancesAreAtMostTwiceTheVertices) {
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    Random random(seed);
    const ClassicCase c = inside(ClassicMethod::orourke, random);
    ClassicReport report;
    orourke(c.a, c.b, c.operation, &report);
    EXPECT_LE(report.steps, 2 * (c.a.points.size() + c.b.points.size()));
  }
}

void expect_refused(ClassicMethod method, const RegionSet& a, const RegionSet& b, const Place& place,
                    const std::string& words) {
  try {
    classic(method, a, b, Operation::intersection);
    ADD_FAILURE() << name_of(method) << " admitted it";
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::precondition);
    EXPECT_EQ(e.place().operand, place.operand);
    EXPECT_EQ(e.place().contour, place.contour);
    EXPECT_EQ(e.place().vertex, place.vertex);
    EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("; use "), std::string::npos) << e.what();
  }
}

TEST(ClassicsRefuse, WithThePlace) {
  const RegionSet good = rectangle(0, 0, 4, 4);
  const RegionSet dent = one_contour({{0, 0}, {4, 0}, {2, 1}, {4, 4}});
  expect_refused(ClassicMethod::orourke, dent, good, {0, 0, 0, 2}, "turns the other way");
  expect_refused(ClassicMethod::sutherland_hodgman, good, dent, {1, 0, 0, 2}, "not convex");
  const RegionSet bow_tie = one_contour({{0, 0}, {4, 4}, {4, 0}, {0, 4}});
  expect_refused(ClassicMethod::weiler_atherton, good, bow_tie, {1, 0, 0, 0}, "crosses");
  expect_refused(ClassicMethod::margalit_knott, bow_tie, good, {0, 0, 0, 0}, "vertex-complete");
}

TEST(ClassicsRefuse, SymmetricDifference) {
  const RegionSet r = rectangle(0, 0, 1, 1);
  for (const ClassicMethod method : all_methods)
    EXPECT_THROW(classic(method, r, r, Operation::symmetric_difference), Error) << name_of(method);
}

TEST(ClassicsRefuse, BadCoordinatesFirst) {
  RegionSet bad = rectangle(0, 0, 1, 1);
  bad.points[1].x = 1e200;
  for (const ClassicMethod method : all_methods) {
    try {
      classic(method, bad, bad, Operation::intersection);
      ADD_FAILURE() << name_of(method);
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ErrorCode::out_of_domain);
    }
  }
}

TEST(ClipWindow, ClipsLikeOverlay) {
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    Random random(seed);
    const ClassicCase c = inside(ClassicMethod::sutherland_hodgman, random);
    EXPECT_EQ(ClipWindow(c.b).clip(c.a), by_pipeline(c.a, c.b, Operation::intersection)) << wkt(c.a) << '\n'
                                                                                         << wkt(c.b);
  }
}

TEST(ClipWindow, OneWindowManyPolygons) {
  const ClipWindow window(2, 2, 8, 7);
  const RegionSet as_regions = rectangle(2, 2, 8, 7);
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    Random random(seed);
    Plane plane(random, random.one_in(2) ? Spread::grid : Spread::reals, 9);
    const RegionSet subject = one_contour(simple(plane, 12));
    EXPECT_EQ(window.clip(subject), by_pipeline(subject, as_regions, Operation::intersection)) << wkt(subject);
  }
}

TEST(ClipWindow, OutsideAndInsideByTheBox) {
  const ClipWindow window(0, 0, 10, 10);
  EXPECT_TRUE(window.clip(rectangle(11, 0, 12, 1)).empty());
  EXPECT_EQ(window.clip(rectangle(1, 1, 2, 2)), rectangle(1, 1, 2, 2));
  EXPECT_THROW(ClipWindow(1, 0, 1, 2), Error);
}

}  // namespace
