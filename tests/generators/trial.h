// One hostile case: what is asked of the library, and whether every promise that can be checked quickly held.
#pragma once

#include <oblast/options.h>

#include <cstdint>
#include <optional>
#include <string>

#include "generators/hostile.h"

namespace oblast::generators {

/// What a case asks for; drawn from the case's seed.
struct Request {
  FillRule fill_a;
  FillRule fill_b;
  ContourConvention contours = ContourConvention::ogc;
  CollinearVertices collinear = CollinearVertices::keep;
  std::uint64_t seed = 0;      ///< of the shuffling
  bool other_threads = false;  ///< compare with two threads (costly)
  bool other_engines = false;  ///< compare with every engine that is present
  double patience = 60;        ///< seconds after which a call is cancelled, and counts as an exception
};

Request draw_request(std::uint64_t seed);
std::string to_text(const Request& request);

enum class Broken { unverified, not_idempotent, order_dependent, threw, engines_differ, area };

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
/// a byte; threw: an exception; engines_differ; area: the areas of the four results contradict each other.
std::optional<Failure> run_trial(const Operands& operands, const Request& request, Figures& figures);

/// The operand with polygons and contours in another order, starts rotated, contours reversed where
/// the fill rule does not see it.
RegionSet shuffled(const RegionSet& regions, const FillRule& rule, std::uint64_t seed);

}  // namespace oblast::generators
