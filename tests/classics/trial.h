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
  long empty = 0;            ///< inside, results that are empty
  long handed_over[3] = {};  ///< inside, handed to the settled noding, by Spread
  long wrong = 0;            ///< inside, bytes that differ or an exception
  long admitted = 0;         ///< outside, no Error(precondition)
  std::string first_failure;
};

TrialCount run_trial(ClassicMethod method, long inside, long outside, std::uint64_t seed);

}  // namespace oblast::tests
