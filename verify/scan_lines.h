// Judging a result along whole lines.
#pragma once

#include "verify/judge_points.h"

namespace oblast::verify {

/// Follows `lines` lines, half of them level and half upright, and compares every stretch of them on which nothing may
/// change with what the operation says. Counts into the report and returns the first wrong place.
/// Cost: O(n + c log c) for c crossings of edges and lines; memory for some million of them at a time.
std::optional<WrongPlace> judge_lines(const Segments& segments, const Question& question, std::uint32_t lines,
                                      std::uint64_t seed, double bound, int threads, OracleReport& report);

}  // namespace oblast::verify
