#include "engines/skvortsov/classify.h"

#include "base/call.h"
#include "base/call_memory.h"
#include "result/select.h"

namespace oblast::internal::skvortsov {
namespace {

using triangulation::half_edge;
using triangulation::HalfEdge;
using triangulation::triangle_of;

class Eating {
 public:
  Eating(const ChainGraph& graph, const MarkedMesh& marked) : graph_(graph), marked_(marked) {
    result_.face.assign(marked.mesh.triangles.size(), none);
  }

  Classification run() {
    const auto& triangles = marked_.mesh.triangles;
    std::uint32_t ghost = 0;
    while (ghost < triangles.size() && !triangles[ghost].is_ghost()) ++ghost;
    result_.winding.push_back({});
    if (ghost < triangles.size()) flood(ghost, 0);

    Array<HalfEdge> border;
    while (!border_.empty()) {
      border.swap(border_);
      border_.clear();
      for (const HalfEdge h : border) step_across(h);
    }
    return std::move(result_);
  }

 private:
  /// Steps 4 and 6 of the paper: across a marked side, from its left to its right.
  void step_across(HalfEdge h) {
    const std::uint32_t beyond = triangle_of(marked_.mesh.twin(h));
    if (result_.face[beyond] != none) return;
    const auto face = static_cast<std::uint32_t>(result_.winding.size());
    const Winding here = result_.winding[result_.face[triangle_of(h)]];
    result_.winding.push_back(here - graph_.change(marked_.mark[h]));
    flood(beyond, face);
  }

  /// Step A: floods everything up to the marked sides. These become the border for the next step.
  void flood(std::uint32_t seed, std::uint32_t face) {
    result_.face[seed] = face;
    pending_.push_back(seed);
    while (!pending_.empty()) {
      steps_();
      const std::uint32_t t = pending_.back();
      pending_.pop_back();
      for (std::uint32_t i = 0; i < 3; ++i) {
        const HalfEdge h = half_edge(t, i);
        const std::uint32_t beyond = triangle_of(marked_.mesh.twin(h));
        if (result_.face[beyond] != none) continue;
        if (marked_.mark[h] != none) {
          border_.push_back(h);
          continue;
        }
        result_.face[beyond] = face;
        pending_.push_back(beyond);
      }
    }
  }

  const ChainGraph& graph_;
  const MarkedMesh& marked_;
  Classification result_;
  Array<std::uint32_t> pending_;
  Steps steps_;
  Array<HalfEdge> border_;  ///< marked sides whose left triangle was visited and whose right one was not
};

}  // namespace

Classification classify(const ChainGraph& graph, const MarkedMesh& marked) { return Eating(graph, marked).run(); }

Array<bool> select_faces(const Classification& classification, Operation operation, const Options& options) {
  Array<bool> kept;
  kept.reserve(classification.winding.size());
  for (const Winding& w : classification.winding)
    kept.push_back(admits(operation, is_inside(options.fill_a, w.a), is_inside(options.fill_b, w.b)));
  return kept;
}

}  // namespace oblast::internal::skvortsov
