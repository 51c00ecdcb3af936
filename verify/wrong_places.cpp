#include "verify/wrong_places.h"

#include <cmath>

#include "verify/edges.h"
#include "verify/estimate.h"

namespace oblast::verify {
namespace {

double length_of(const std::vector<InputEdge>& edges) {
  double length = 0;
  for (const InputEdge& e : edges) length += std::abs(e.to.x - e.from.x) + std::abs(e.to.y - e.from.y);
  return length;
}

}  // namespace

std::optional<Fault> judge_wrong_places(const ForEachWrong& for_each_wrong, const Sources& sources,
                                        const std::string& wrong_here, const std::string& too_large) {
  std::optional<RationalPoint> wrong;
  Estimate wrong_area = 0.0;
  for_each_wrong([&](const Trapezoid& t) {
    wrong_area = wrong_area + t.estimated_area();
    if (!wrong && !sources.near_any(t)) wrong = t.centre();
  });
  if (wrong) {
    const Point p{round_to_nearest(wrong->x), round_to_nearest(wrong->y)};
    return Fault{"around " + to_text(p) + " " + wrong_here, {}};
  }
  const double most = 2 * length_of(sources.edges());
  if (certainly_less(wrong_area, Estimate(sources.bound()) * Estimate(most))) return std::nullopt;
  // Sums of many fractions with different denominators are slow, so this is left for where it is needed.
  Rational exact_area = 0;
  for_each_wrong([&](const Trapezoid& t) { exact_area += t.area(); });
  if (exact_area > Rational(sources.bound()) * Rational(most)) return Fault{too_large, {}};
  return std::nullopt;
}

}  // namespace oblast::verify
