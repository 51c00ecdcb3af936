// The shares of the stages in the time of a call, for progress: rounded means over fires, stars, slabs and
// checkerboards.
#pragma once

namespace oblast::internal {

// Shares of the call. The rest is for joining the parts.
inline constexpr double collect_share = 0.1, parting_share = 0.05, parts_share = 0.75;
// Shares of stages 2 to 6. The rest is for assembling.
inline constexpr double node_share = 0.6, label_share = 0.1, select_share = 0.03, link_share = 0.1, nest_share = 0.05;

// The share in a triangulation of the union that comes first.
inline constexpr double union_share = 0.5;

// Of a check, of what the steps before leave. Not measured.
inline constexpr double check_meetings_share = 0.6, check_faces_share = 0.9;

// Of the repair of a coverage. The rest is for slivers and for joining. Not measured.
inline constexpr double coverage_arrangement_share = 0.4, coverage_gaps_share = 0.2, coverage_union_share = 0.2;

// Of a repair of features one by one. The rest is for joining.
inline constexpr double repair_share = 0.95;

// Of a buffer, for the union of the regions, and of the rows of one that has rows. Not measured.
inline constexpr double buffer_union_share = 0.3, buffer_rows_share = 0.95;

// Of zones, for cutting the objects, and of what is left, for sampling them. Not measured.
inline constexpr double zone_objects_share = 0.1, zone_sampling_share = 0.5;

}  // namespace oblast::internal
