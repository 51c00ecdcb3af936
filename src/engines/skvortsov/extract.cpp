#include "engines/skvortsov/extract.h"

#include "base/call.h"
#include "base/call_memory.h"
#include "base/stage_shares.h"
#include "engines/skvortsov/classify.h"
#include "engines/skvortsov/contours.h"
#include "engines/skvortsov/marked_mesh.h"

namespace oblast::internal::skvortsov {
namespace {

using triangulation::triangle_of;

Kept kept_triangles(const Classification& classes, const Array<bool>& kept_faces) {
  Kept kept(classes.face.size());
  for (std::size_t t = 0; t < kept.size(); ++t) kept[t] = kept_faces[classes.face[t]];
  return kept;
}

/// The chains between a kept and a dropped triangle. They determine the kinds of the nodes.
Selection selection_of(const ChainGraph& graph, const MarkedMesh& marked, const Kept& kept) {
  Selection selection(graph.chains.size(), none);
  for (std::uint32_t c = 0; c < graph.chains.size(); ++c) {
    const triangulation::HalfEdge h = marked.first_side[c];
    if (h == none) continue;
    const bool left = kept[triangle_of(h)], right = kept[triangle_of(marked.mesh.twin(h))];
    if (left != right) selection[c] = left ? forward(c) : opposite(forward(c));
  }
  return selection;
}

Rings rings_of(const MarkedMesh& marked, const Contours& contours, const NodeKinds& kinds) {
  Rings rings;
  rings.ends = contours.ends;
  rings.points.reserve(contours.vertices.size());
  rings.flags.reserve(contours.vertices.size());
  for (const std::uint32_t v : contours.vertices) {
    rings.points.push_back(marked.mesh.points[v]);
    rings.flags.push_back(marked.node[v] == none ? std::uint8_t{0} : kinds.flags[marked.node[v]]);
  }
  add_trace_edges(
      kinds, [&](std::uint32_t i) { return marked.node[contours.vertices[i]]; }, rings);
  return rings;
}

}  // namespace

Extracted extract(const ChainGraph& graph, Operation operation, const Options& options, Control& control,
                  Statistics& statistics) {
  MarkedMesh marked;
  Classification classes;
  {
    const InStage stage(Stage::label, label_share, control, statistics);
    marked = mark_mesh(graph);
    classes = classify(graph, marked);
  }
  Kept kept;
  {
    const InStage stage(Stage::select, select_share, control, statistics);
    kept = kept_triangles(classes, select_faces(classes, operation, options));
  }
  const InStage stage(Stage::link, link_share, control, statistics);
  Contours contours = walk_contours(marked.mesh, kept, options.contours);
  Rings rings = rings_of(marked, contours, classify_nodes(graph, selection_of(graph, marked, kept)));
  return {std::move(rings), std::move(contours.nesting)};
}

}  // namespace oblast::internal::skvortsov
