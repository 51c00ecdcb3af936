// Questions that once broke a promise.
#include <gtest/gtest.h>

#include "zones/zone_trial.h"

namespace oblast::testing {
namespace {

void keeps_every_promise(const ZoneQuestion& question) {
  const auto failure = run_zone_trial(question, {1, 500, false});
  EXPECT_FALSE(failure) << to_text(failure->broken) << ": " << failure->what;
}

// Noding makes the two edges of the second object overlap along x = 5. There one of them runs up and the other down, so
// they cancelled, and the line was lost.
TEST(KeptZones, EdgesOfOneObjectThatNodingTurnedAroundDoNotCancel) {
  ZoneQuestion question;
  const Point across[] = {{1, 1.9}, {5.0000000000000009, 2.0000000000000004}, {4, 1}};
  const Point up_and_down[] = {
      {2, 4}, {5, 1}, {5.0000000000000009, 5.0000000000000009}, {4.9999999999999991, 4}, {5, 0.99999999999999989}};
  question.add_line(across);
  question.add_line(up_and_down);
  question.options.relative_tolerance = 5e-4;
  keeps_every_promise(question);
}

// The vertical line of the first object and the slanted one of the second meet in (0, 1); the second ends an ulp above.
// All triangles beside the slanted line are too thin for a strip, so it must go on behind them.
TEST(KeptZones, ALineBetweenThinTrianglesIsInItsZone) {
  ZoneQuestion question;
  question.regions = {{{0, 0},
                       {0.99999999999999989, -0.99999999999999989},
                       {-0.99999999999999978, 0},
                       {0.99999999999999989, 0},
                       {1, -1.0000000000000004},
                       {-0.99999999999999978, 1}},
                      {6},
                      {1}};
  const Point vertical[] = {{0, 0}, {0, -1}, {0, 1.0000000000000002}, {0, 0}};
  const Point slanted[] = {{-1, -1.0000000000000002}, {0, 1.0000000000000002}, {-1.0000000000000002, 0},
                           {-1.0000000000000004, 0},  {1.0000000000000004, 0}, {0, 1},
                           {-1, -1.0000000000000002}};
  question.add_line(vertical);
  question.add_line(slanted);
  question.frame = {{{-2.4346039202037431, -0.49167410233054465},
                     {1.4223692982738307, -0.49167410233054465},
                     {1.4223692982738307, 1.2899526421096694},
                     {-2.4346039202037431, 1.2899526421096694}},
                    {4},
                    {1}};
  question.options.relative_tolerance = 1.1736203732782993e-3;
  keeps_every_promise(question);
}

// A border around a single place was flattened to an edge of no length, which became a contour of one vertex.
TEST(KeptZones, FlattenedBordersHaveNoEdgesOfNoLength) {
  ZoneQuestion question;
  question.regions = {{{9.2233720368583373e+18, 9.2233720368573481e+18},
                       {9.2233720368576287e+18, 9.2233720368568443e+18},
                       {9.2233720368571822e+18, 9.2233720368564654e+18},
                       {9.2233720368582636e+18, 9.223372036855081e+18},
                       {9.2233720368593265e+18, 9.2233720368568648e+18},
                       {9.22337203685581e+18, 9.2233720368554168e+18},
                       {9.2233720368569651e+18, 9.2233720368555049e+18},
                       {9.2233720368589251e+18, 9.223372036856062e+18},
                       {9.2233720368585933e+18, 9.2233720368571064e+18}},
                      {3, 9},
                      {2}};
  const Point first[] = {
      {9.2233720368568586e+18, 9.2233720368585073e+18}, {9.2233720368583803e+18, 9.2233720368571617e+18},
      {9.2233720368584806e+18, 9.2233720368593367e+18}, {9.2233720368553452e+18, 9.2233720368563364e+18},
      {9.2233720368588472e+18, 9.2233720368594084e+18}, {9.2233720368568586e+18, 9.2233720368585073e+18}};
  const Point second[] = {{9.2233720368572989e+18, 9.2233720368582164e+18},
                          {9.2233720368571187e+18, 9.2233720368551772e+18},
                          {9.2233720368593879e+18, 9.2233720368561869e+18},
                          {9.2233720368548925e+18, 9.2233720368582246e+18},
                          {9.2233720368593756e+18, 9.2233720368566497e+18}};
  question.add_line(first);
  question.add_line(second);
  question.options.relative_tolerance = 0.016176236424107131;
  question.options.distance = 134939.51852330557;
  keeps_every_promise(question);
}

}  // namespace
}  // namespace oblast::testing
