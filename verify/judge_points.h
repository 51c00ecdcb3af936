// Judges many points at once, by descending into smaller and smaller boxes of points with the edges that can reach
// them.
#pragma once

#include <span>

#include "verify/oracle.h"
#include "verify/segments.h"

namespace oblast::verify {

/// The operands, fill rules and operation of a result.
struct Question {
  Operation operation;
  FillRule rule_a, rule_b;
  std::size_t polygons_a, polygons_b;
};

/// Adds counts to the report. Returns the first wrong point in the order of probes.
std::optional<WrongPlace> judge_points(const Segments& segments, const Question& question,
                                       std::span<const Probe> probes, double bound, int threads, OracleReport& report);

}  // namespace oblast::verify
