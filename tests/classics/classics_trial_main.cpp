// Random cases for every classic: inside its domain the bytes of `overlay`, outside an error each time; and for the
// fast paths of `overlay`: the bytes of its pipeline.
//
//   oblast_classics_trial [INSIDE [OUTSIDE [SEED]]]      defaults: 100000 10000 1; each a method
#include <oblast/oblast.h>

#include <cstdio>
#include <cstdlib>

#include "classics/cases.h"
#include "classics/trial.h"

int main(int argc, char** argv) {
  const auto argument = [&](int i, long otherwise) { return argc > i ? std::atol(argv[i]) : otherwise; };
  const long inside = argument(1, 100000), outside = argument(2, 10000);
  const auto seed = static_cast<std::uint64_t>(argument(3, 1));
  bool all_good = true;
  std::printf("%-20s %9s %9s %9s %9s %9s %21s %9s %9s %9s\n", "method", "inside", "meeting", "holes", "bridges",
              "empty", "handed g/r/n", "wrong", "outside", "admitted");
  for (const oblast::ClassicMethod method : oblast::tests::all_methods) {
    const oblast::tests::TrialCount count = oblast::tests::run_trial(method, inside, outside, seed);
    std::printf("%-20s %9ld %9ld %9ld %9ld %9ld %7ld%7ld%7ld %9ld %9ld %9ld\n", oblast::tests::name_of(method), inside,
                count.meeting, count.holes, count.bridges, count.empty, count.handed_over[0], count.handed_over[1],
                count.handed_over[2], count.wrong, outside, count.admitted);
    if (!count.first_failure.empty()) std::printf("  first failure: %s\n", count.first_failure.c_str());
    std::fflush(stdout);
    all_good &= count.wrong == 0 && count.admitted == 0;
  }
  const oblast::tests::WindowTrialCount fast = oblast::tests::run_window_trial(inside, seed);
  std::printf("fast paths of overlay: %ld cases, taken grid %ld, reals %ld, nearly %ld; %ld not empty, %ld wrong\n",
              inside, fast.taken[0], fast.taken[1], fast.taken[2], fast.not_empty, fast.wrong);
  if (!fast.first_failure.empty()) std::printf("  first failure: %s\n", fast.first_failure.c_str());
  all_good &= fast.wrong == 0;
  return all_good ? 0 : 1;
}
