// Judges a result along whole lines.
#pragma once

#include "verify/judge_points.h"

namespace oblast::verify {

/// Scans `lines` lines, half of them horizontal and half vertical, and compares every stretch on which nothing may
/// change with the operation. Adds counts to the report. Returns the first wrong place. Cost: O(n + c log c) for c
/// crossings of edges and lines; memory for some million crossings at a time.
std::optional<WrongPlace> judge_lines(const Segments& segments, const Question& question, std::uint32_t lines,
                                      std::uint64_t seed, double bound, int threads, OracleReport& report);

}  // namespace oblast::verify
