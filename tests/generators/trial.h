// One hostile case: what is asked of the library, and whether every promise that can be checked quickly held; alone,
// and with others far away. In a crowd: crowd.h.
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

/// Runs all four operations on the operands. The first failure, if there is one:
/// unverified: the result is not closed or not canonical; not_idempotent: uniting it changes a byte;
/// order_dependent: shuffled and, as far as the fill rule allows, reversed contours or two threads change
/// a byte; far: squares that lie elsewhere (far.h) change a byte of the chosen operation; threw: an exception;
/// engines_differ; area: the areas of the four results contradict each other; wrong: the result of the chosen operation
/// is not what exact recomputation says (recomputation.h). `crowd` is not asked here (crowd.h).
std::optional<Failure> run_trial(const Operands& operands, const Request& request, Figures& figures);

/// The operands of the call in which others lie far away: what a failure `far` is about.
Operands with_others_far_away(const Operands& operands, const Request& request);

/// The operand with polygons and contours in another order, starts rotated, contours reversed where
/// the fill rule does not see it.
RegionSet shuffled(const RegionSet& regions, const FillRule& rule, std::uint64_t seed);

}  // namespace oblast::generators
