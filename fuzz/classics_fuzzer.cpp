// The classics and the clip window: outside its domain a method is refused, inside it gives the bytes of an overlay.
#include <oblast/hull.h>
#include <oblast/overlay.h>

#include <algorithm>

#include "bytes_to_operands.h"
#include "classics/cases.h"
#include "classics/trial.h"

namespace {

using namespace oblast;

void compare(ClassicMethod method, const RegionSet& a, const RegionSet& b, Operation operation,
             const fuzz::Input& input) {
  RegionSet result;
  try {
    result = classic(method, a, b, operation);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::precondition) return;
    throw;
  }
  tests::ClassicCase same;
  same.a = a;
  same.b = b;
  same.operation = operation;
  if (result != tests::expected(method, same))
    fuzz::report({generators::Broken::engines_differ, operation, tests::name_of(method)}, {{a, b}, input.request});
}

void compare_all(const RegionSet& a, const RegionSet& b, const fuzz::Input& input) {
  for (const ClassicMethod method : tests::all_methods) {
    for (const Operation operation : {Operation::intersection, Operation::unite, Operation::difference})
      compare(method, a, b, operation, input);
  }
}

// The outer contour of the first polygon: simple, so in the domain of Margalit and Knott.
RegionSet first_contour(const RegionSet& regions) {
  if (regions.empty()) return {};
  const auto contour = regions.view().contour(0);
  return {{contour.begin(), contour.end()}, {static_cast<std::uint32_t>(contour.size())}, {1}};
}

void clip(const RegionSet& subject, const RegionSet& window, const fuzz::Input& input) {
  if (window.empty()) return;
  RegionSet expected;
  try {
    expected = sutherland_hodgman(subject, window);
  } catch (const Error&) {
    return;
  }
  if (ClipWindow(window).clip(subject) != expected)
    fuzz::report({generators::Broken::engines_differ, Operation::intersection, "clip window"}, input);
}

// The rectangle round `window`, given by its sides.
void clip_to_box(const RegionSet& subject, const RegionSet& window, const fuzz::Input& input) {
  if (window.empty()) return;
  Point low = window.points[0], high = low;
  for (const Point& p : window.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  if (low.x == high.x || low.y == high.y) return;
  const RegionSet box{{low, {high.x, low.y}, high, {low.x, high.y}}, {4}, {1}};
  if (ClipWindow(low.x, low.y, high.x, high.y).clip(subject) != overlay(subject, box, Operation::intersection))
    fuzz::report({generators::Broken::engines_differ, Operation::intersection, "clip window of a box"}, input);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const fuzz::Input input = fuzz::input_from(bytes, size);
  const auto& [a, b] = input.operands;
  compare_all(a, b, input);
  // Bytes hardly ever make a convex or a simple contour, so such are made of them.
  const RegionSet hull_a = hull(a), hull_b = hull(b), united_a = unite(a), united_b = unite(b);
  compare_all(hull_a, hull_b, input);
  compare_all(united_a, hull_b, input);
  compare_all(united_a, united_b, input);
  compare_all(first_contour(united_a), first_contour(united_b), input);
  clip(united_a, hull_b, input);
  clip(a, hull_b, input);
  clip_to_box(a, hull_b, input);
  return 0;
}
