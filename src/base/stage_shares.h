// What part of a call its stages take, for progress: rounded means over fires, stars, slabs and checkerboards.
#pragma once

namespace oblast::internal {

// Of the call. What is left is for putting the parts together.
inline constexpr double collect_share = 0.1, parting_share = 0.05, parts_share = 0.75;
// Of stages 2 to 6. What is left is for assembling.
inline constexpr double node_share = 0.6, label_share = 0.1, select_share = 0.03, link_share = 0.1, nest_share = 0.05;

// Of a triangulation: the union that comes first.
inline constexpr double union_share = 0.5;

// Of a check, of what the steps before leave. Not measured.
inline constexpr double check_meetings_share = 0.6, check_faces_share = 0.9;

}  // namespace oblast::internal
