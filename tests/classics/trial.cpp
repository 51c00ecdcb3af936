#include "classics/trial.h"

#include <oblast/oblast.h>

#include "classics/cases.h"
#include "classics/wkt.h"
#include "window/fast_path.h"

namespace oblast::tests {
using namespace internal;

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

std::string failure(const ClassicCase& c, std::uint64_t seed, const std::string& what) {
  return "seed " + std::to_string(seed) + ", operation " + std::to_string(static_cast<int>(c.operation)) + ": " + what +
         "\n  A " + wkt(c.a) + "\n  B " + wkt(c.b);
}

void note(TrialCount& count, const ClassicCase& c, std::uint64_t seed, const std::string& what) {
  if (count.first_failure.empty()) count.first_failure = failure(c, seed, what);
}

/// True if the error names the fault, as indices and in words, and another method.
bool is_good_refusal(const Error& e, OutsideCase::Names names) {
  const std::string what = e.what();
  const auto says = [&](const char* words) { return what.find(words) != std::string::npos; };
  if (e.code() != ErrorCode::precondition || !says("; use ")) return false;
  if (names == OutsideCase::Names::nothing) return true;
  if (e.place().operand > 1 || e.place().contour == Place::npos || !says(", contour ")) return false;
  return names == OutsideCase::Names::contour || (e.place().vertex != Place::npos && says(", vertex "));
}

bool has_hole(const RegionSet& r) { return r.contour_ends.size() > r.polygon_ends.size(); }

/// An edge walked there and back: a bridge, as a keyhole has.
bool has_bridge(const RegionSet& r) {
  if (r.contour_ends.size() != 1) return false;
  const std::size_t n = r.points.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      if (r.points[i] == r.points[(j + 1) % n] && r.points[(i + 1) % n] == r.points[j]) return true;
  return false;
}

}  // namespace

TrialCount run_trial(ClassicMethod method, long inside_cases, long outside_cases, std::uint64_t seed) {
  TrialCount count;
  for (long i = 0; i < inside_cases; ++i) {
    const std::uint64_t case_seed = seed * 1000000007 + static_cast<std::uint64_t>(i);
    Random random(case_seed);
    const ClassicCase c = inside(method, random);
    count.holes += has_hole(c.a) || has_hole(c.b);
    count.bridges += has_bridge(c.a) || has_bridge(c.b);
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
      if (is_good_refusal(e, o.names)) continue;
      ++count.admitted;
      note(count, c, case_seed, o.why + ", another error: " + e.what());
    }
  }
  return count;
}

WindowTrialCount run_window_trial(long cases, std::uint64_t seed) {
  WindowTrialCount count;
  for (long i = 0; i < cases; ++i) {
    const std::uint64_t case_seed = seed * 1000000011 + static_cast<std::uint64_t>(i);
    Random random(case_seed);
    const ClassicCase c = window_case(random);
    const std::optional<RegionSet> got = window::fast_overlay(c.a, c.b, c.operation, {});
    if (!got) continue;
    const RegionSet wanted = by_pipeline(c.a, c.b, c.operation);
    ++count.taken[static_cast<int>(c.spread)];
    count.not_empty += !wanted.empty();
    if (*got == wanted) continue;
    if (count.wrong++ == 0)
      count.first_failure = failure(c, case_seed, "wrong\n  got  " + wkt(*got) + "\n  want " + wkt(wanted));
  }
  return count;
}

}  // namespace oblast::tests
