// Runs one hostile case, alone and with others far away, and checks every promise that can be checked quickly. crowd.h
// runs cases in a crowd.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "generators/hostile.h"
#include "generators/request.h"

namespace oblast::generators {

enum class Broken { unverified, not_idempotent, order_dependent, far, crowd, threw, engines_differ, area, wrong };
inline constexpr int broken_count = 9;

const char* to_text(Broken broken);

struct Failure {
  Broken broken;
  Operation operation;
  std::string what;
};

/// Largest figures of the calls of a trial.
struct Figures {
  std::uint64_t rounds = 0;
  double displacement_ulps = 0;
};

/// Runs all four operations on the operands, and returns the first failure, if any:
/// - unverified: the result is not closed or not canonical.
/// - not_idempotent: uniting the result changes a byte.
/// - order_dependent: a byte changes if contours are shuffled and (as far as the fill rule allows) reversed, or with
/// two
///   threads.
/// - far: squares elsewhere (far.h) change a byte of the chosen operation.
/// - threw: an exception.
/// - engines_differ: another engine gives other bytes.
/// - area: the areas of the four results contradict each other.
/// - wrong: the result of the chosen operation differs from exact recomputation (recomputation.h).
/// `crowd` is not tested here (crowd.h).
std::optional<Failure> run_trial(const Operands& operands, const Request& request, Figures& figures);

/// The operands of the call with others far away, for a failure `far`.
Operands with_others_far_away(const Operands& operands, const Request& request);

/// The operand with polygons and contours in another order, with rotated starts, and with reversed contours if the fill
/// rule does not depend on directions.
RegionSet shuffled(const RegionSet& regions, const FillRule& rule, std::uint64_t seed);

}  // namespace oblast::generators
