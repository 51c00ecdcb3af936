#include "classics/trial.h"

#include <oblast/oblast.h>

#include "classics/cases.h"
#include "classics/wkt.h"

namespace oblast::tests {

const char* name_of(ClassicMethod method) {
  switch (method) {
    case ClassicMethod::orourke:
      return "orourke";
    case ClassicMethod::sutherland_hodgman:
      return "sutherland-hodgman";
    case ClassicMethod::weiler_atherton:
      return "weiler-atherton";
    default:
      return "margalit-knott";
  }
}

namespace {

void note(TrialCount& count, const ClassicCase& c, std::uint64_t seed, const std::string& what) {
  if (!count.first_failure.empty()) return;
  count.first_failure = "seed " + std::to_string(seed) + ", operation " +
                        std::to_string(static_cast<int>(c.operation)) + ": " + what + "\n  A " + wkt(c.a) + "\n  B " +
                        wkt(c.b);
}

}  // namespace

TrialCount run_trial(ClassicMethod method, long inside_cases, long outside_cases, std::uint64_t seed) {
  TrialCount count;
  for (long i = 0; i < inside_cases; ++i) {
    const std::uint64_t case_seed = seed * 1000000007 + static_cast<std::uint64_t>(i);
    Random random(case_seed);
    const ClassicCase c = inside(method, random);
    try {
      ClassicReport report;
      const RegionSet got = classic(method, c.a, c.b, c.operation, &report);
      const RegionSet wanted = expected(method, c);
      count.meeting += report.meetings > 0;
      count.empty += wanted.empty();
      count.handed_over[static_cast<int>(c.spread)] += report.handed_over;
      if (got == wanted) continue;
      ++count.wrong;
      note(count, c, case_seed, "wrong\n  got  " + wkt(got) + "\n  want " + wkt(wanted));
    } catch (const std::exception& e) {
      ++count.wrong;
      note(count, c, case_seed, std::string("threw: ") + e.what());
    }
  }
  for (long i = 0; i < outside_cases; ++i) {
    const std::uint64_t case_seed = seed * 1000000009 + static_cast<std::uint64_t>(i);
    Random random(case_seed);
    const OutsideCase o = outside(method, random);
    const ClassicCase& c = o.operands;
    try {
      if (method == ClassicMethod::sutherland_hodgman)
        sutherland_hodgman(c.a, c.b);
      else
        classic(method, c.a, c.b, c.operation);
      ++count.admitted;
      note(count, c, case_seed, "admitted: " + o.why);
    } catch (const Error& e) {
      if (e.code() == ErrorCode::precondition) continue;
      ++count.admitted;
      note(count, c, case_seed, "another error: " + std::string(e.what()));
    }
  }
  return count;
}

}  // namespace oblast::tests
