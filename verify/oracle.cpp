// The oracle: tests points, then lines.
#include "verify/oracle.h"

#include <thread>

#include "verify/judge_points.h"
#include "verify/scan_lines.h"

namespace oblast::verify {

std::optional<WrongPlace> look_for_wrong_place(const RegionView& a, const RegionView& b, Operation operation,
                                               const RegionView& result, const OracleOptions& options,
                                               OracleReport* report) {
  OracleReport counted;
  OracleReport& counts = report != nullptr ? *report : counted;
  counts = {};
  const Segments segments(a, b, result);
  if (segments.size() == 0) return std::nullopt;
  counts.bound = options.bound_ulps * segments.unit();
  const int threads =
      options.threads > 0 ? options.threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  const Question question{operation, options.fill_a, options.fill_b, a.polygon_count(), b.polygon_count()};
  const std::vector<Probe> probes = choose_probes(segments, options.points, options.seed);
  std::optional<WrongPlace> wrong = judge_points(segments, question, probes, counts.bound, threads, counts);
  counts.largest_displacement_ulps = segments.unit() > 0 ? counts.largest_displacement / segments.unit() : 0;
  if (!wrong) wrong = judge_lines(segments, question, options.lines, options.seed, counts.bound, threads, counts);
  return wrong;
}

}  // namespace oblast::verify
