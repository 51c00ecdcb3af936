// The pipeline for rows: the stages of overlay/pipeline.h, with source sets in place of winding numbers and a contour
// for each row that an edge bounds.
//
//   1 collect, 2 node   as for region sets; an edge carries the sources it changes (noding/source_changes.h)
//   3 label             the sources of every face (face_labels.h)
//   4 select            borders: edges with different keys on their sides, and their traces (borders.h)
//   5 link, 6 assemble  row by row (rows.h)
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/control.h"
#include "base/memory_budget.h"
#include "collect/collect.h"
#include "collect/independent_parts.h"
#include "features/key_rule.h"

namespace oblast::internal {

struct KeyedJob {
  std::span<const Operand> operands;  ///< those of B have sources of their own
  std::size_t source_count;           ///< of A or of B, whichever has more
  KeyRule rule;
  PartNeeds needs;
  const Options& options;
  Control& control;
};

struct KeyedResult {
  Charge charge;  ///< for the regions
  RegionSet regions;
  std::vector<std::uint32_t> feature_ends;
  Array<RowKey> keys;  ///< by row, ascending; where a key is a set: by row, any
  /// Where a key is a set of sources: those of each row, and past its last one. Rows are in the order of these lists.
  Array<std::uint32_t> sources, source_ends;
};

KeyedResult keyed_overlay(const KeyedJob& job, Statistics& statistics);

/// Stages 2 to 6 of strands from elsewhere, in one batch. REQUIRES: the changes of the strands are handles of
/// `strands.rules.sources`, and around every point they sum to zero; the rule is not by sets.
KeyedResult keyed_overlay_of(noding::Strands strands, const KeyRule& rule, const Options& options, Control& control,
                             Statistics& statistics);

}  // namespace oblast::internal
