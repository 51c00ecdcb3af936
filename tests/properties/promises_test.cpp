// Properties of overlays on small integer grids, on which everything coincides: promises G1 to G4.
//
// RapidCheck draws the operands and shrinks what fails; the checker decides by exact rationals.
#include <gtest/gtest.h>
#include <oblast/overlay.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>
#include <ostream>

#include "generators/soup.h"
#include "generators/trial.h"
#include "generators/wkt.h"
#include "verify/against.h"
#include "verify/slabs.h"

namespace oblast::internal {

// How RapidCheck shows a counterexample.
void showValue(const RegionSet& regions, std::ostream& os) { os << generators::soup_to_wkt(regions); }

namespace {

using generators::Ring;

rc::Gen<Point> grid_point(int extent) {
  const auto coordinate = rc::gen::map(rc::gen::inRange(0, extent + 1), [](int i) { return static_cast<double>(i); });
  return rc::gen::construct<Point>(coordinate, coordinate);
}

// Up to four polygons of up to two rings of three to five corners.
rc::Gen<RegionSet> grid_soup(int extent) {
  const auto ring = rc::gen::mapcat(rc::gen::inRange<std::size_t>(3, 6), [extent](std::size_t corners) {
    return rc::gen::container<Ring>(corners, grid_point(extent));
  });
  const auto polygon = rc::gen::mapcat(rc::gen::inRange<std::size_t>(1, 3), [ring](std::size_t rings) {
    return rc::gen::container<std::vector<Ring>>(rings, ring);
  });
  const auto polygons = rc::gen::mapcat(rc::gen::inRange<std::size_t>(0, 4), [polygon](std::size_t count) {
    return rc::gen::container<std::vector<std::vector<Ring>>>(count, polygon);
  });
  return rc::gen::map(polygons, [](const std::vector<std::vector<Ring>>& drawn) {
    RegionSet soup;
    for (const auto& rings : drawn) {
      for (std::size_t r = 0; r < rings.size(); ++r) {
        r == 0 ? generators::add_polygon(soup, rings[r]) : generators::add_hole(soup, rings[r]);
      }
    }
    return soup;
  });
}

FillRule draw_rule() {
  return *rc::gen::element(FillRule::polygons(), FillRule::even_odd(), FillRule::nonzero(), FillRule::positive(),
                           FillRule::negative(), FillRule::at_least(2));
}

Options draw_options() {
  Options options;
  options.fill_a = draw_rule();
  options.fill_b = draw_rule();
  options.contours = *rc::gen::element(ContourConvention::ogc, ContourConvention::leonov_nikitin);
  options.collinear = *rc::gen::element(CollinearVertices::keep, CollinearVertices::drop);
  options.threads = 1;
  return options;
}

Operation draw_operation() {
  return *rc::gen::element(Operation::intersection, Operation::unite, Operation::difference,
                           Operation::symmetric_difference);
}

// A thousand cases of each property, unless RC_PARAMS sets another number. RapidCheck reads it at the first property.
[[maybe_unused]] const int many_cases = setenv("RC_PARAMS", "max_success=1000", 0);

int draw_extent() { return *rc::gen::inRange(2, 7); }

// Fails with the fault and the call.
void expect_none(const std::optional<verify::Fault>& fault, Operation operation, const Options& options) {
  if (!fault) return;
  const generators::Request request{options.fill_a, options.fill_b, options.contours, options.collinear};
  RC_FAIL(fault->what + "; operation " + std::to_string(static_cast<int>(operation)) + " " +
          generators::to_text(request));
}

RC_GTEST_PROP(Promises, resultsAreClosedAndCanonical, ()) {
  const int extent = draw_extent();
  const RegionSet a = *grid_soup(extent), b = *grid_soup(extent);
  const Options options = draw_options();
  const Operation operation = draw_operation();
  const RegionSet result = overlay(a, b, operation, options);
  expect_none(verify::check_result(result, options.contours), operation, options);
}

RC_GTEST_PROP(Promises, resultsAreTheRightAnswer, ()) {
  const int extent = draw_extent();
  const RegionSet a = *grid_soup(extent), b = *grid_soup(extent);
  const Operation operation = draw_operation();
  const Options options = draw_options();
  const RegionSet result = overlay(a, b, operation, options);
  // Two units: coordinates are rounded once to the nearest double, hardly ever a second time.
  expect_none(verify::check_against(a, b, operation, options, result, 2), operation, options);
}

// Found by the property above: two straightened edges in each other's way, and one that comes to lie on (1 4).
TEST(Promises, oneOfTwoTracesIsTakenOut) {
  const RegionSet a = generators::soup_from_wkt(
      "MULTIPOLYGON (((0 5, 0 0, 4 2, 0 5)), ((1 4, 0 0, 1 0, 1 4)), ((0 4, 0 0, 3 3, 0 4)))");
  for (const char* text : {"MULTIPOLYGON (((2 3, 3 2, 0 0, 2 3)), ((4 3, 3 0, 2 0, 4 3), (0 5, 2 4, 4 1, 0 5)))",
                           "MULTIPOLYGON (((3 3, 0 0, 1 0, 3 3)), ((4 3, 3 0, 2 0, 4 3), (0 0, 4 1, 0 5, 0 0)))"}) {
    const RegionSet b = generators::soup_from_wkt(text);
    for (const ContourConvention contours : {ContourConvention::ogc, ContourConvention::leonov_nikitin}) {
      Options options;
      options.contours = contours;
      const RegionSet result = overlay(a, b, Operation::intersection, options);
      const auto fault = verify::check_against(a, b, Operation::intersection, options, result, 2);
      EXPECT_FALSE(fault) << fault->what;
    }
  }
}

RC_GTEST_PROP(Promises, unitingAResultChangesNothing, ()) {
  const int extent = draw_extent();
  const RegionSet a = *grid_soup(extent), b = *grid_soup(extent);
  const Options options = draw_options();
  const RegionSet result = overlay(a, b, draw_operation(), options);
  Options again = options;
  again.fill_a = FillRule::polygons();
  RC_ASSERT(unite(result, again) == result);
}

RC_GTEST_PROP(Promises, orderAndThreadsDoNotMatter, ()) {
  const int extent = draw_extent();
  const RegionSet a = *grid_soup(extent), b = *grid_soup(extent);
  const Operation operation = draw_operation();
  Options options = draw_options();
  const RegionSet result = overlay(a, b, operation, options);
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  options.threads = 2;
  RC_ASSERT(overlay(generators::shuffled(a, options.fill_a, seed), generators::shuffled(b, options.fill_b, ~seed),
                    operation, options) == result);
}

RC_GTEST_PROP(Promises, uniteIsTheOverlayWithNothing, ()) {
  const RegionSet a = *grid_soup(draw_extent());
  const Options options = draw_options();
  RC_ASSERT(unite(a, options) == overlay(a, RegionSet{}, Operation::unite, options));
}

// |A or B| + |A and B| = |A| + |B| and its likes: exact on the arrangement (which checks the checker), and within
// the displacement for the results.
RC_GTEST_PROP(Promises, areasAddUp, ()) {
  const int extent = draw_extent();
  const RegionSet a = *grid_soup(extent), b = *grid_soup(extent);
  const Options options = draw_options();
  const RegionSet none;
  const auto exact = [&](const RegionSet& p, const RegionSet& q, Operation operation) {
    return verify::exact_area({p, options.fill_a}, {q, options.fill_b}, operation);
  };
  const auto of_result = [&](const RegionSet& p, const RegionSet& q, Operation operation) {
    return verify::exact_signed_area(overlay(p, q, operation, options));
  };
  const auto check_identities = [&](const auto& area, const verify::Rational& tolerance) {
    const auto all = area(a, b, Operation::unite), both = area(a, b, Operation::intersection);
    const auto only_a = area(a, b, Operation::difference), either = area(a, b, Operation::symmetric_difference);
    const auto area_a = area(a, none, Operation::unite), area_b = area(none, b, Operation::unite);
    RC_ASSERT(abs(all + both - area_a - area_b) <= tolerance);
    RC_ASSERT(abs(either + both - all) <= tolerance);
    RC_ASSERT(abs(only_a + both - area_a) <= tolerance);
  };
  check_identities(exact, 0);
  // Coordinates are below 8 and move by at most two units of 2^-50; edges are at most 10 long and at most 60.
  check_identities(of_result, verify::Rational(60 * 10 * 0x1p-48));
}

}  // namespace
}  // namespace oblast::internal
