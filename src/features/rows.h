// Stages 5 and 6 for rows: the borders of each row linked to contours, and the contours put together.
//
// A border enters once for each row that it bounds. So each row has a graph of its own: nodes and borders of the
// arrangement, copied for this row. Rows are taken a range at a time; within a range the stages that a single region
// set goes through (result/link.h, nesting.h, assemble.h) serve all rows at once.
#pragma once

#include <cstdint>

#include "base/memory_budget.h"
#include "features/borders.h"
#include "features/key_rule.h"

namespace oblast::internal {

/// Rows of one batch, by ranges of rows.
struct BatchRows {
  Array<RowKey> keys;                ///< by row, ascending
  Array<RegionSet> regions;          ///< by range; the polygons come row by row
  Array<Array<std::uint32_t>> rows;  ///< by range: the row of each polygon
  Array<Charge> charges;             ///< by range
};

/// Cost: linear in the vertices of all rows, plus O(e log e) for e borders of rows, plus what nest and assemble cost.
BatchRows build_rows(const Borders& borders, const LabelSets& sets, const KeyRule& rule, ContourConvention contours);

}  // namespace oblast::internal
