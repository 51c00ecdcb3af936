// Stage 4 for rows: the borders between faces with different keys, as paths from node to node.
//
//   ---x----.----t----x---      x: three or more borders meet here. Between two of them all borders are one path, with
//      |              |         the same rows on its left, and the same on its right, from end to end.
//
// Traces of noding (t) are taken out of the paths, once for all rows: the rows on either side keep or lose the same
// vertex. So rows that share a border share its vertices (promise G8).
#pragma once

#include <cstdint>

#include "features/face_labels.h"
#include "features/key_rule.h"
#include "result/rings.h"

namespace oblast::internal {

struct BorderEnd {
  std::uint32_t node = none;   ///< none where the path is closed
  std::uint32_t place = none;  ///< in the graph's lists: grows counter-clockwise around the node
};

struct Borders {
  Rings paths;                   ///< without traces; the first and the last vertex of an open path are its ends
  Array<BorderEnd> from, to;     ///< by path
  Array<FaceLabel> left, right;  ///< by path: of its first edge
};

/// Cost: linear in the chains, and as remove_traces.
Borders find_borders(const ChainGraph& graph, const FaceLabels& labels, const LabelSets& sets, const KeyRule& rule,
                     CollinearVertices collinear);

}  // namespace oblast::internal
