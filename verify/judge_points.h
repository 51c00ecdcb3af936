// Judging many points at once: a descent into ever smaller boxes of points, with the edges that can reach them.
#pragma once

#include <span>

#include "verify/oracle.h"
#include "verify/segments.h"

namespace oblast::verify {

/// The question a result answers.
struct Question {
  Operation operation;
  FillRule rule_a, rule_b;
  std::size_t polygons_a, polygons_b;
};

/// Counts into the report and returns the first wrong point, by the order of probes.
std::optional<WrongPlace> judge_points(const Segments& segments, const Question& question,
                                       std::span<const Probe> probes, double bound, int threads, OracleReport& report);

}  // namespace oblast::verify
