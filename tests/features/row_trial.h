// One hostile case of rows: every operation, and whether every promise held.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "generators/hostile.h"

namespace oblast::testing {

enum class BrokenRows { unverified, order, far, threads, wrong, identities, threw };
inline constexpr int broken_rows_count = 7;
const char* to_text(BrokenRows broken);

struct RowFailure {
  BrokenRows broken;
  std::string operation;
  std::string what;
};

/// Runs the five overlays, dissolve, depth and partition on rows drawn from the operands.
/// unverified: verify::check_rows; order: rows with their polygons, contours and starts in another order; far: with
/// squares elsewhere (generators/far.h); threads: two of them; wrong: a row is not where its key says, by exact
/// arithmetic (asked where `exact` is set; costly); identities: dissolve to one row is not `unite`, or the partition of
/// a layer with itself is not that of the layer.
std::optional<RowFailure> run_row_trial(const generators::Operands& operands, std::uint64_t seed, bool exact);

}  // namespace oblast::testing
