// Runs many random cases of one classic and counts what came of them.
#pragma once

#include <oblast/classics.h>

#include <cstdint>
#include <string>

namespace oblast::tests {

inline constexpr ClassicMethod all_methods[] = {ClassicMethod::orourke, ClassicMethod::sutherland_hodgman,
                                                ClassicMethod::weiler_atherton, ClassicMethod::margalit_knott};

const char* name_of(ClassicMethod method);

struct TrialCount {
  long meeting = 0;          ///< inside, boundaries that meet
  long holes = 0;            ///< inside, an operand with holes
  long bridges = 0;          ///< inside, an operand whose contour walks an edge there and back
  long empty = 0;            ///< inside, results that are empty
  long handed_over[3] = {};  ///< inside, handed to the settled noding, by Spread
  long wrong = 0;            ///< inside, bytes that differ or an exception
  long admitted = 0;         ///< outside the domain: no error, or one that does not name the fault and another method
  std::string first_failure;
};

/// The fast paths of `overlay` against its pipeline.
struct WindowTrialCount {
  long taken[3] = {};  ///< by Spread
  long not_empty = 0;  ///< of those taken
  long wrong = 0;      ///< bytes that differ
  std::string first_failure;
};

WindowTrialCount run_window_trial(long cases, std::uint64_t seed);

TrialCount run_trial(ClassicMethod method, long inside, long outside, std::uint64_t seed);

}  // namespace oblast::tests
