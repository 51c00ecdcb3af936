// Everything that grows beyond 32-bit indices is refused. For builds with low limits (base/index_limits.h).
#include <gtest/gtest.h>
#include <oblast/overlay.h>
#include <oblast/triangulate.h>

#include <functional>
#include <string>

#include "base/index.h"
#include "graph/chain_graph.h"
#include "noding/arrange_cuts.h"
#include "noding/insert_cuts.h"
#include "noding/merge_identical_edges.h"
#include "result/assemble.h"

namespace oblast::internal {
namespace {

using noding::Strands;

/// What there are too many of, according to the message; empty if nothing was refused.
std::string too_many(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::too_large) << error.what();
    const std::string what = error.what();
    return what.substr(what.find_first_of("0123456789"));
  }
  return "";
}

std::string more_than(std::size_t most, const std::string& what) { return std::to_string(most) + ' ' + what; }

class TooMany : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!low_index_limits) GTEST_SKIP() << "the limits of this build are those of 32 bits";
  }
};

/// One path, back and forth, whose edges do not meet.
Strands zigzag(std::size_t vertices) {
  Strands strands;
  for (std::size_t i = 0; i < vertices; ++i) strands.points.push_back({static_cast<double>(i), i % 2 ? 1.0 : 0.0});
  return strands;
}

TEST_F(TooMany, verticesOfStrands) {
  Strands strands = zigzag(most_indices);
  EXPECT_EQ(too_many([&] { strands.close_strand({1, 0}, noding::any_group); }), "");
  strands.points.push_back({-1, 0});
  EXPECT_EQ(too_many([&] {
              strands.close_strand({1, 0}, noding::any_group);
            }),
            more_than(most_indices, "vertices of strands"));
}

TEST_F(TooMany, verticesOfTheCuts) {
  Strands strands = zigzag(3);
  strands.flags.assign(3, 0);
  strands.close_strand({1, 0}, noding::any_group);
  LargeArray<noding::EdgeCut> cuts(most_indices - 3, {1, 0, {1.5, 0.5}});
  EXPECT_EQ(too_many([&] { noding::insert_cuts(strands, cuts); }), "");
  EXPECT_EQ(strands.points.size(), most_indices);
  EXPECT_EQ(too_many([&] { noding::insert_cuts(strands, std::span(cuts).first(1)); }),
            more_than(most_indices, "vertices with those of the cuts"));
}

TEST_F(TooMany, cuts) {
  Strands strands = zigzag(3);
  strands.close_strand({1, 0}, noding::any_group);
  const LargeArray<noding::EdgeCut> cuts(most_indices + 1, {1, 0, {1.5, 0.5}});
  const std::span<const noding::EdgeCut> all = cuts, most = all.first(most_indices);
  EXPECT_EQ(too_many([&] { noding::arrange_cuts(strands, std::span(&most, 1), {}, nullptr); }), "");
  EXPECT_EQ(too_many([&] { noding::arrange_cuts(strands, std::span(&all, 1), {}, nullptr); }),
            more_than(most_indices, "cuts"));
}

// If every second edge is repeated, the rest of a path consists of strands with one edge.
TEST_F(TooMany, strandsThatRepeatedEdgesLeave) {
  Strands strands = zigzag(most_indices - 2);
  strands.close_strand({1, 0}, noding::any_group);
  noding::IdenticalEdges identical;
  identical.first_of.assign(strands.points.size() - 1, none);
  identical.sum.assign(strands.points.size() - 1, {2, 0});
  for (std::uint32_t e = 0; e < identical.first_of.size(); e += 2) identical.first_of[e] = e;
  EXPECT_EQ(too_many([&] { noding::merge_identical_edges(strands, identical); }),
            more_than(most_indices, "vertices of strands"));
}

TEST_F(TooMany, chains) {
  for (const std::size_t chains : {most_chains, most_chains + 1}) {
    Strands strands = zigzag(chains + 1);
    strands.flags.assign(chains + 1, noding::node_flag);
    strands.close_strand({1, 0}, noding::any_group);
    EXPECT_EQ(too_many([&] { build_chain_graph(strands); }),
              chains == most_chains ? "" : more_than(most_chains, "chains"));
  }
}

Rings one_ring(std::size_t vertices) {
  Rings rings;
  for (std::size_t i = 0; i < vertices; ++i)
    rings.points.push_back({static_cast<double>(i), static_cast<double>(i) * static_cast<double>(i)});
  rings.flags.resize(vertices, 0);
  rings.ends = {static_cast<std::uint32_t>(vertices)};
  return rings;
}

TEST_F(TooMany, verticesOfTheResult) {
  Nesting nesting;
  nesting.polygon = {0};
  nesting.outer = {1};
  nesting.polygon_count = 1;
  EXPECT_EQ(too_many([&] { assemble(one_ring(most_vertices), nesting); }), "");
  EXPECT_EQ(too_many([&] { assemble(one_ring(most_vertices + 1), nesting); }),
            more_than(most_vertices, "vertices of the result"));
}

TEST_F(TooMany, verticesOfPartsTogether) {
  const auto part = [](std::size_t vertices, double x) {
    RegionSet regions;
    regions.points.assign(vertices, {x, 0});
    regions.contour_ends = {static_cast<std::uint32_t>(vertices)};
    regions.polygon_ends = {1};
    return regions;
  };
  const std::size_t half = most_vertices / 2;
  EXPECT_EQ(too_many([&] { join({part(half, 0), part(most_vertices - half, 1)}); }), "");
  EXPECT_EQ(too_many([&] {
              join({part(half, 0), part(most_vertices - half + 1, 1)});
            }),
            more_than(most_vertices, "vertices of the result"));
}

TEST_F(TooMany, verticesToTriangulate) {
  RegionSet ring;
  ring.points = {{0, -1}};
  for (std::size_t i = 0; i < most_mesh_vertices; ++i)
    ring.points.push_back({static_cast<double>(i), static_cast<double>(i) * static_cast<double>(i)});
  ring.contour_ends = {static_cast<std::uint32_t>(ring.points.size())};
  ring.polygon_ends = {1};
  TriangulateOptions as_it_is;
  as_it_is.input = TriangleInput::result;
  EXPECT_EQ(too_many([&] { triangulate(ring, as_it_is); }), more_than(most_mesh_vertices, "vertices to triangulate"));
  Options options;
  options.engine = Engine::skvortsov;
  EXPECT_EQ(too_many([&] { unite(ring, options); }), more_than(most_mesh_vertices, "vertices to triangulate"));
}

// From the outside: two combs that cross more often than there are indices, found before the cuts fill the memory.
TEST_F(TooMany, crossingsOfTwoCombs) {
  RegionSet combs[2];
  constexpr int teeth = 1100;
  for (const bool turned : {false, true}) {
    RegionSet& comb = combs[turned];
    const auto add = [&](double x, double y) { comb.points.push_back(turned ? Point{y, x} : Point{x, y}); };
    add(0, -1);
    for (int i = 0; i < teeth; ++i) {
      add(2 * i, 2.0 * teeth + 1);
      add(2 * i + 1, 1.0 / (i + 2));
    }
    add(2.0 * teeth, -1);
    comb.contour_ends = {static_cast<std::uint32_t>(comb.points.size())};
    comb.polygon_ends = {1};
  }
  for (const int threads : {1, 2}) {
    Options options;
    options.threads = threads;
    EXPECT_EQ(too_many([&] { overlay(combs[0], combs[1], Operation::intersection, options); }),
              more_than(most_indices, "cuts"));
  }
}

}  // namespace
}  // namespace oblast::internal
