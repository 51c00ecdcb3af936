// Step 2: which triangles are inside each operand. The triangles are "eaten" inwards from the hull (section 3.1).
//
//   +-----------------+     mode 0: flood from infinity up to marked sides
//   | 1  +-------+    |     mode 1: step across these, and flood again
//   |    | 2     |    | 0   mode 2: step across the next ones, and flood again ...
//   +----+-------+----+
//
// Each triangle is eaten once. A flood has one pair of winding numbers. A step across a side changes it by the change
// of the side. (The paper only switches between "outside" and "inside".)
#pragma once

#include <oblast/options.h>

#include "base/call_memory.h"
#include "engines/skvortsov/marked_mesh.h"

namespace oblast::internal::skvortsov {

struct Classification {
  Array<std::uint32_t> face;  ///< by triangle: the flood that reached it; 0 is the outside
  Array<Winding> winding;     ///< by face: winding numbers of A and B
};

/// Cost: O(n).
Classification classify(const ChainGraph& graph, const MarkedMesh& marked);

/// Step 3: applies the truth table to each face.
Array<bool> select_faces(const Classification& classification, Operation operation, const Options& options);

}  // namespace oblast::internal::skvortsov
