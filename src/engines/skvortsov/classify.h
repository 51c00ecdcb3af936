// Step 2: which triangles are inside of each operand, by eating inwards from the hull (section 3.1).
//
//   +-----------------+     mode 0: flood from infinity, up to marked sides
//   | 1  +-------+    |     mode 1: step across them, flood on
//   |    | 2     |    | 0   mode 2: step across the next ones, flood on ...
//   +----+-------+----+
//
// Each triangle is eaten once. A flood has one pair of winding numbers; stepping across a side changes it
// by the change of the side, where the paper only turns "outside" into "inside" and back.
#pragma once

#include <oblast/options.h>

#include "base/call_memory.h"
#include "engines/skvortsov/marked_mesh.h"

namespace oblast::internal::skvortsov {

struct Classification {
  Array<std::uint32_t> face;  ///< by triangle: the flood that ate it; 0 is the outside
  Array<Winding> winding;     ///< by face: winding numbers of A and B
};

/// Cost: O(n).
Classification classify(const ChainGraph& graph, const MarkedMesh& marked);

/// Step 3: the truth table, by face.
Array<bool> select_faces(const Classification& classification, Operation operation, const Options& options);

}  // namespace oblast::internal::skvortsov
