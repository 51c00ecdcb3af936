// check_against finds each kind of wrong answer, and lets right ones pass; areas and slabs by hand.
#include <gtest/gtest.h>
#include <oblast/overlay.h>
#include <oblast/wkt.h>

#include <algorithm>
#include <cmath>

#include "verify/against.h"
#include "verify/slabs.h"
#include "verify/text_regions.h"

namespace oblast::verify {
namespace {

struct Question {
  std::string a, b;
  Operation operation;
  Options options = {};
};

std::string fault_of(const Question& q, const RegionSet& result, Provenance* provenance = nullptr) {
  const auto fault = check_against(regions_of(q.a), regions_of(q.b), q.operation, q.options, result, 4, provenance);
  return fault ? fault->what : "";
}

std::string fault_of(const Question& q, const std::string& result) { return fault_of(q, regions_of(result)); }

void expect_fault(const Question& q, const std::string& result, const std::string& part) {
  const std::string what = fault_of(q, result);
  EXPECT_NE(what.find(part), std::string::npos) << "'" << what << "' instead of '" << part << "'";
  EXPECT_NE(what, "");
}

const std::string square = "0 0, 4 0, 4 4, 0 4";
const std::string shifted = "2 2, 6 2, 6 6, 2 6";

TEST(CheckAgainst, letsRightAnswersPass) {
  EXPECT_EQ(fault_of({square, shifted, Operation::intersection}, "2 2, 4 2, 4 4, 2 4"), "");
  EXPECT_EQ(fault_of({square, shifted, Operation::unite}, "0 0, 4 0, 4 2, 6 2, 6 6, 2 6, 2 4, 0 4"), "");
  EXPECT_EQ(fault_of({square, shifted, Operation::difference}, "0 0, 4 0, 4 2, 2 2, 2 4, 0 4"), "");
  EXPECT_EQ(fault_of({square, "", Operation::intersection}, ""), "");
}

TEST(CheckAgainst, findsTheAnswerToAnotherQuestion) {
  expect_fault({square, shifted, Operation::intersection}, "0 0, 4 0, 4 2, 6 2, 6 6, 2 6, 2 4, 0 4", "not what");
  expect_fault({square, shifted, Operation::unite}, "2 2, 4 2, 4 4, 2 4", "not what");
  expect_fault({square, shifted, Operation::unite}, "", "not what");
  expect_fault({square, shifted, Operation::difference}, "2 4, 4 4, 4 2, 6 2, 6 6, 2 6", "not what");  // B \ A
}

TEST(CheckAgainst, findsVerticesFromNowhere) {
  expect_fault({square, "", Operation::unite}, "0 0, 4 0, 4 4, 1 4, 0 4", "neither an input vertex");
  expect_fault({square, "", Operation::unite}, "0 0, 4 0, 5 5, 0 4", "neither an input vertex");
  expect_fault({square, shifted, Operation::intersection}, "2 2, 4 2, 4 4", "does not lie along any input edge");
}

TEST(CheckAgainst, findsAnInputVertexThatIsMissing) {
  const std::string with_vertex = "0 0, 2 0, 4 0, 4 4, 0 4";
  EXPECT_EQ(fault_of({with_vertex, "", Operation::unite}, with_vertex), "");
  expect_fault({with_vertex, "", Operation::unite}, square, "does not lie along any input edge");
  Question minimal{with_vertex, "", Operation::unite};
  minimal.options.collinear = CollinearVertices::drop;
  EXPECT_EQ(fault_of(minimal, square), "");
  expect_fault(minimal, with_vertex, "exactly between");
}

TEST(CheckAgainst, findsATipThatIsMissing) {
  const Question touched{square, "2 0, 1 -2, 3 -2", Operation::difference};
  EXPECT_EQ(fault_of(touched, "0 0, 2 0, 4 0, 4 4, 0 4"), "");
  expect_fault(touched, square, "was left out");
}

// The tip of B's first polygon is 2^-105 below an edge of the second one. A crossing of that edge is rounded, and the
// tip is above it: a flat tip, whose edges cancel. So the left side of A, on which it lies exactly, does not keep it.
TEST(CheckAgainst, letsATipCancelWhereRoundingPutsItBeyondAnEdge) {
  const RegionSet a =
      read_wkt("POLYGON ((0 -1.0000000000000004, 3 0.9999999999999999, 0 1.0000000000000004, 0 -1.0000000000000004))");
  const RegionSet tip = read_wkt(
      "POLYGON ((-1.0000000000000004 0, 0.9999999999999999 -1.0000000000000004, 0 0.9999999999999999, "
      "-1.0000000000000004 0))");
  const RegionSet b = read_wkt(
      "MULTIPOLYGON (((-1.0000000000000004 0, 0.9999999999999999 -1.0000000000000004, 0 0.9999999999999999, "
      "-1.0000000000000004 0)), ((-0.9999999999999998 1, 1.0000000000000002 0.9999999999999998, "
      "0 1.0000000000000002, -0.9999999999999999 0, -0.9999999999999998 1)))");
  EXPECT_EQ(check_against(a, b, Operation::intersection, {}, overlay(a, b, Operation::intersection)), std::nullopt);
  // Without the second polygon the tip is a vertex of the result, and must be.
  const RegionSet kept = overlay(a, tip, Operation::intersection);
  EXPECT_EQ(std::count(kept.points.begin(), kept.points.end(), Point{0, 0.9999999999999999}), 1);
}

TEST(CheckAgainst, findsTraces) {
  // Two cells clipped by a square: where their common border met the square, nothing may be left.
  const Question clipped{"0 0, 2 0, 2 4, 0 4 | 2 0, 4 0, 4 4, 2 4", "1 1, 3 1, 3 3, 1 3", Operation::intersection};
  EXPECT_EQ(fault_of(clipped, "1 1, 3 1, 3 3, 1 3"), "");
  expect_fault(clipped, "1 1, 2 1, 3 1, 3 3, 1 3", "trace");
}

TEST(CheckAgainst, countsWhereVerticesComeFrom) {
  const Question q{"0 0, 3 1, 0 1", "1 -1, 2 -1, 2 2, 1 2", Operation::intersection};
  Provenance provenance;
  EXPECT_EQ(fault_of(q, regions_of("1 0.3333333333333333, 2 0.6666666666666666, 2 1, 1 1"), &provenance), "");
  EXPECT_EQ(provenance.input_vertices, 0u);
  EXPECT_EQ(provenance.intersections, 4u);
  EXPECT_EQ(provenance.largest_displacement_ulps, 0);  // each lies exactly on an upright edge
  // One unit off is the product of a later rounding round, at best; a million of them is a fault.
  RegionSet moved = regions_of("1 0.3333333333333333, 2 0.6666666666666666, 2 1, 1 1");
  provenance = {};
  moved.points[1].y = std::nextafter(moved.points[1].y, 1);
  EXPECT_EQ(fault_of(q, moved, &provenance), "");
  EXPECT_EQ(provenance.later_rounds, 1u);
  moved.points[1].y = 0.6666666667;
  EXPECT_NE(fault_of(q, moved), "");
}

TEST(Slabs, areasByEveryRule) {
  // Two overlapping squares of one layer, the second clockwise.
  const RegionSet layer = regions_of("0 0, 4 0, 4 4, 0 4 | 2 2, 2 6, 6 6, 6 2");
  const RegionSet nothing;
  const auto area = [&](const FillRule& rule) {
    return exact_area({layer, rule}, {nothing, FillRule::polygons()}, Operation::unite);
  };
  EXPECT_EQ(area(FillRule::polygons()), 28);
  EXPECT_EQ(area(FillRule::at_least(2)), 4);
  EXPECT_EQ(area(FillRule::even_odd()), 24);
  EXPECT_EQ(area(FillRule::nonzero()), 24);
  EXPECT_EQ(area(FillRule::positive()), 12);
  EXPECT_EQ(area(FillRule::negative()), 12);
}

TEST(Slabs, areasOfCrossingsThatAreNoDoubles) {
  // The line y = x / 3 cuts the unit cell at thirds.
  const RegionSet wedge = regions_of("0 0, 3 1, 0 1"), cell = regions_of("1 0, 2 0, 2 1, 1 1");
  const auto area = [&](Operation operation) {
    return exact_area({wedge, FillRule::polygons()}, {cell, FillRule::polygons()}, operation);
  };
  EXPECT_EQ(area(Operation::intersection), Rational(1) / 2);
  EXPECT_EQ(area(Operation::unite), 2);
  EXPECT_EQ(area(Operation::difference), 1);
  EXPECT_EQ(area(Operation::symmetric_difference), Rational(3) / 2);
  EXPECT_EQ(exact_signed_area(wedge), Rational(3) / 2);
}

}  // namespace
}  // namespace oblast::verify
