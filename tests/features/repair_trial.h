// One hostile case of repair and of repair_coverage, and whether every promise held.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generators/hostile.h"

namespace oblast::testing {

enum class BrokenRepair { unverified, area, again, order, far, threads, wrong, threw };
inline constexpr int broken_repair_count = 8;
const char* to_text(BrokenRepair broken);

struct RepairFailure {
  BrokenRepair broken;
  std::string operation;
  std::string what;
};

/// What another program may look at: the features as WKT.
struct RepairedTexts {
  std::vector<std::string> features, coverage;
};

/// Repairs rows drawn from the operands, one by one and as a coverage with random options.
/// unverified: verify::check_rows of each repaired row by itself, and of all rows of the coverage in canonical form;
/// area: a feature that came back as it was has another area than its resolved region, exactly; or a row of the
/// coverage is not what an overlay leaves as it is; again: a second repair changes something; order: rows with their
/// polygons, contours and starts in another order; far: with squares elsewhere; threads: two of them; wrong: a row is
/// not where it should be, by exact arithmetic (asked where `exact` is set; costly).
std::optional<RepairFailure> run_repair_trial(const generators::Operands& operands, std::uint64_t seed, bool exact,
                                              RepairedTexts* texts = nullptr);

}  // namespace oblast::testing
