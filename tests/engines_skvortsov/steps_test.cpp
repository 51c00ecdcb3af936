// The engine step by step: the marked triangulation, and the windings that eating inwards finds.
#include <gtest/gtest.h>

#include <set>

#include "engines/skvortsov/classify.h"
#include "engines_skvortsov/arrangement.h"
#include "generators/trial.h"
#include "support/check_mesh.h"
#include "support/exact_signs.h"

namespace oblast::testing {
namespace {

using namespace triangulation;
using skvortsov::MarkedMesh;

class Steps : public ::testing::TestWithParam<generators::HostileGenerator> {};

TEST_P(Steps, everyEdgeIsASideOfTheTriangulation) {
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    const ChainGraph graph = arrangement_of(GetParam().make(seed, 60), options_of(generators::draw_request(seed)));
    const MarkedMesh marked = skvortsov::mark_mesh(graph);
    const Mesh& mesh = marked.mesh;
    std::vector<Constraint> constraints;
    std::size_t edges = 0;
    for (std::uint32_t c = 0; c < graph.chains.size(); ++c)
      if (graph.is_live(c)) edges += graph.chains[c].last - graph.chains[c].first;
    for (HalfEdge h = 0; h < marked.mark.size(); ++h) {
      if (side_of(h) == 3 || marked.mark[h] == none) continue;
      ASSERT_EQ(marked.mark[mesh.twin(h)], opposite(marked.mark[h]));
      ASSERT_TRUE(graph.is_live(chain_of(marked.mark[h])));
      if (!is_backward(marked.mark[h])) constraints.push_back({mesh.origin(h), mesh.target(h)});
    }
    ASSERT_EQ(constraints.size(), edges) << "seed " << seed;
    const auto fault = check_mesh(mesh, constraints);
    ASSERT_FALSE(fault) << "seed " << seed << ": " << *fault;
  }
}

/// The winding numbers around the point (x, y) / 3, by a ray to the right; it lies on no edge.
Winding winding_at(const ChainGraph& graph, const std::vector<IntegerPoint>& points, const Integer& x,
                   const Integer& y) {
  Winding sum;
  for (std::uint32_t c = 0; c < graph.chains.size(); ++c) {
    if (!graph.is_live(c)) continue;
    for (std::uint32_t v = graph.chains[c].first; v < graph.chains[c].last; ++v) {
      const IntegerPoint &p = points[v], &q = points[v + 1];
      const bool p_above = 3 * p.y > y, q_above = 3 * q.y > y;
      if (p_above == q_above) continue;
      // Upward edges have the point on their left when they are to its right.
      const Integer side = (q.x - p.x) * (y - 3 * p.y) - (q.y - p.y) * (x - 3 * p.x);
      if (q_above && side > 0) sum = sum + graph.chains[c].change;
      if (p_above && side < 0) sum = sum - graph.chains[c].change;
    }
  }
  return sum;
}

/// Under even_odd changes are known modulo 2 only.
bool same_winding(const FillRule& rule, std::int32_t found, std::int32_t expected) {
  return rule.kind == FillRule::Kind::even_odd ? ((found - expected) & 1) == 0 : found == expected;
}

TEST_P(Steps, eatingInwardsFindsTheWindingNumbers) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Options options = options_of(generators::draw_request(seed));
    const ChainGraph graph = arrangement_of(GetParam().make(seed, 40), options);
    const MarkedMesh marked = skvortsov::mark_mesh(graph);
    const skvortsov::Classification classes = skvortsov::classify(graph, marked);
    LargeArray<Point> all = graph.strands.points;
    all.insert(all.end(), marked.mesh.points.begin(), marked.mesh.points.end());
    const std::vector<IntegerPoint> points = to_integers(all);
    const auto vertex = [&](std::uint32_t v) -> const IntegerPoint& { return points[graph.strands.points.size() + v]; };
    for (std::uint32_t t = 0; t < marked.mesh.triangles.size(); ++t) {
      const Triangle& triangle = marked.mesh.triangles[t];
      const Winding found = classes.winding[classes.face[t]];
      if (triangle.is_ghost()) {
        ASSERT_TRUE(found.is_zero());
        continue;
      }
      const auto& v = triangle.vertex;
      const Winding expected = winding_at(graph, points, vertex(v[0]).x + vertex(v[1]).x + vertex(v[2]).x,
                                          vertex(v[0]).y + vertex(v[1]).y + vertex(v[2]).y);
      ASSERT_TRUE(same_winding(options.fill_a, found.a, expected.a) &&
                  same_winding(options.fill_b, found.b, expected.b))
          << "seed " << seed << " triangle " << t << ": " << found.a << ' ' << found.b << ", not " << expected.a << ' '
          << expected.b;
    }
  }
}

std::string name_of(const ::testing::TestParamInfo<generators::HostileGenerator>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Generators, Steps,
                         ::testing::ValuesIn(generators::hostile_generators().begin(),
                                             generators::hostile_generators().end()),
                         name_of);

}  // namespace
}  // namespace oblast::testing
