// The pair search against every pair: no two edges that meet may be missed, whichever way cells are cut.
#include "noding/pair_finder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "generators/random.h"
#include "support/strands_of.h"
#include "verify/predicates.h"

namespace oblast::internal::noding {
namespace {

using generators::Random;
using testing::Path;
using testing::strands_of;
using verify::side_of_line;

using EdgePair = std::uint64_t;

EdgePair pair_of(std::uint32_t i, std::uint32_t j) {
  return static_cast<std::uint64_t>(std::min(i, j)) << 32 | std::max(i, j);
}

Box box_of(const Strands& strands, std::uint32_t e) { return Box::of(strands.points[e], strands.points[e + 1]); }

/// Closed edges with a point in common.
bool meet(const Strands& strands, std::uint32_t i, std::uint32_t j) {
  const Point &a = strands.points[i], &b = strands.points[i + 1], &c = strands.points[j], &d = strands.points[j + 1];
  return box_of(strands, i).meets(box_of(strands, j)) && side_of_line(a, b, c) * side_of_line(a, b, d) <= 0 &&
         side_of_line(c, d, a) * side_of_line(c, d, b) <= 0;
}

/// The pairs of edges that the search visits, sorted, of those whose boxes meet.
std::vector<EdgePair> visited(const Strands& strands, LargeArray<Run> runs) {
  std::mutex mutex;
  std::vector<EdgePair> pairs;
  find_pairs(strands.points, std::move(runs), [&](std::span<const RunPair> batch) {
    const std::lock_guard lock(mutex);
    for (const RunPair& pair : batch)
      for (std::uint32_t i = pair.first_p; i < pair.last_p; ++i)
        for (std::uint32_t j = pair.first_q; j < pair.last_q; ++j)
          if (box_of(strands, i).meets(box_of(strands, j))) pairs.push_back(pair_of(i, j));
  });
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

bool ends_at(const Strands& strands, std::uint32_t e, const Point& x) {
  return strands.points[e] == x || strands.points[e + 1] == x;
}

/// Edges that meet in a common end only. A cut along an edge through it may part them (cell_cut.cpp).
bool meet_in_an_end(const Strands& strands, std::uint32_t i, std::uint32_t j) {
  const Point &a = strands.points[i], &b = strands.points[i + 1], &c = strands.points[j], &d = strands.points[j + 1];
  return !verify::meet_badly(a, b, c, d);
}

/// The edges through x are linked by visited pairs, or follow one another, so that each is seen to meet another there.
bool linked_at(const Strands& strands, const Point& x, const std::vector<EdgePair>& found) {
  std::vector<std::uint32_t> left;
  for (const std::uint32_t e : testing::edges_of(strands))
    if (box_of(strands, e).meets(Box::of(x, x)) && side_of_line(strands.points[e], strands.points[e + 1], x) == 0)
      left.push_back(e);
  std::vector<std::uint32_t> reached{left.back()};
  left.pop_back();
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const auto linked = [&](std::uint32_t e) {
      const bool follows = reached[i] + 1 == e || e + 1 == reached[i];
      return follows || std::binary_search(found.begin(), found.end(), pair_of(reached[i], e));
    };
    const auto unreached = std::partition(left.begin(), left.end(), [&](std::uint32_t e) { return !linked(e); });
    reached.insert(reached.end(), unreached, left.end());
    left.erase(unreached, left.end());
  }
  return left.empty();
}

/// Every two edges of different runs that meet are visited, but where both runs are of one group; those that
/// meet in a common end may be visited by way of others. Returns how many pairs meet.
std::size_t expect_all_found(const Strands& strands) {
  const LargeArray<noding::Run> runs = monotone_runs(strands, Grouping::by_strand);
  const std::vector<EdgePair> found = visited(strands, runs);
  struct Edge {
    std::uint32_t edge, run;
    Box box;
  };
  std::vector<Edge> edges;
  for (std::uint32_t r = 0; r < runs.size(); ++r)
    for (std::uint32_t e = runs[r].first; e < runs[r].last; ++e) edges.push_back({e, r, box_of(strands, e)});
  std::size_t count = 0, missed = 0;
  std::vector<Point> common_ends;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      if (!edges[i].box.meets(edges[j].box) || edges[i].run == edges[j].run) continue;
      const Group group = runs[edges[i].run].group;
      if (group != any_group && group == runs[edges[j].run].group) continue;
      const std::uint32_t p = edges[i].edge, q = edges[j].edge;
      if (!meet(strands, p, q)) continue;
      ++count;
      if (std::binary_search(found.begin(), found.end(), pair_of(p, q))) continue;
      if (meet_in_an_end(strands, p, q))
        common_ends.push_back(ends_at(strands, q, strands.points[p]) ? strands.points[p] : strands.points[p + 1]);
      else
        ++missed;
    }
  }
  EXPECT_EQ(missed, 0u) << "of " << count;
  std::sort(common_ends.begin(), common_ends.end(), lexicographically_less);
  common_ends.erase(std::unique(common_ends.begin(), common_ends.end()), common_ends.end());
  for (const Point& x : common_ends) EXPECT_TRUE(linked_at(strands, x, found)) << x.x << " " << x.y;
  return count;
}

Path edge(const Point& a, const Point& b) { return {a, b}; }

TEST(PairFinder, findsRandomEdges) {
  Random random(1);
  for (const int n : {40, 513, 3000}) {
    std::vector<Path> paths;
    const double length = 3 / std::sqrt(n);
    for (int i = 0; i < n; ++i) {
      const Point p{random.unit(), random.unit()};
      paths.push_back(edge(p, {p.x + random.in(-length, length), p.y + random.in(-length, length)}));
    }
    EXPECT_GT(expect_all_found(strands_of(paths)), static_cast<std::size_t>(n / 3));
  }
}

TEST(PairFinder, findsAcrossThreads) {
  // Enough entries that cells are cut in parallel; short edges, so that few pairs meet.
  Random random(2);
  std::vector<Path> paths;
  for (int i = 0; i < 21000; ++i) {
    const Point p{random.unit(), random.unit()};
    paths.push_back(edge(p, {p.x + random.in(-0.01, 0.01), p.y + random.in(-0.01, 0.01)}));
  }
  EXPECT_GT(expect_all_found(strands_of(paths)), 5000u);
}

TEST(PairFinder, findsRunsOfSeveralEdges) {
  Random random(3);
  std::vector<Path> paths;
  for (int i = 0; i < 300; ++i) {
    Path path{{random.unit(), random.unit()}};
    for (int k = 0; k < 10; ++k)
      path.push_back({path.back().x + random.in(-0.01, 0.03), path.back().y + random.in(-0.01, 0.03)});
    paths.push_back(path);
  }
  EXPECT_GT(expect_all_found(strands_of(paths)), 1000u);
}

TEST(PairFinder, findsLongSlabs) {
  // Long thin boxes along both axes: every cut is straddled by half of them.
  Random random(4);
  std::vector<Path> paths;
  for (int i = 0; i < 400; ++i) {
    const double at = random.unit();
    paths.push_back(edge({0, at}, {1, at + random.in(-1e-3, 1e-3)}));
    paths.push_back(edge({at + random.in(-1e-3, 1e-3), 0}, {at, 1}));
  }
  EXPECT_GT(expect_all_found(strands_of(paths)), 100000u);
}

/// `n` long edges that run side by side in a band around the line from p to q.
void add_bundle(std::vector<Path>& paths, Random& random, int n, const Point& p, const Point& q, double width) {
  for (int i = 0; i < n; ++i) {
    const auto near = [&](const Point& at) {
      return Point{at.x + random.in(-width, width), at.y + random.in(-width, width)};
    };
    paths.push_back(random.one_in(2) ? edge(near(p), near(q)) : edge(near(q), near(p)));
  }
}

TEST(PairFinder, findsBundles) {
  for (const double width : {1e-1, 1e-4, 1e-12, 1e-16}) {
    Random random(5);
    std::vector<Path> paths;
    add_bundle(paths, random, 400, {0, 0}, {1, 1}, width);
    EXPECT_GT(expect_all_found(strands_of(paths)), 20000u) << width;
  }
}

TEST(PairFinder, losesNoCrossingThatAClippedCellOwned) {
  // A crossing was lost where a clipped cell owned a pair. A dense bundle makes its cells clipped; small boxes
  // beside it make leaves that are not; long edges run from the ones into the others and cross there, while
  // the lower left corner that their boxes share is in a clipped cell.
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Random random(seed);
    std::vector<Path> paths;
    add_bundle(paths, random, 600, {0, 0}, {1, 1}, 0.01);
    for (int i = 0; i < 600; ++i) {
      const double x = random.in(1.2, 2.2), y = random.in(1.2, 2.2), size = random.in(0, 0.02);
      paths.push_back(testing::closed(testing::box(x, y, x + size, y + size)));
    }
    add_bundle(paths, random, 25, {0.2, 0.2}, {2.1, 2.1}, 0.1);
    expect_all_found(strands_of(paths));
  }
}

TEST(PairFinder, findsBundlesThatCrossAmongSmallBoxes) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Random random(seed);
    std::vector<Path> paths;
    const double width = std::pow(10, -1 - 4 * random.unit());
    const int in_bundle = 300 + random.below(300);
    add_bundle(paths, random, in_bundle, {-1, -1 + 0.3 * random.unit()}, {1, 1}, width);
    add_bundle(paths, random, in_bundle, {-1, 1}, {1, -1 + 0.3 * random.unit()}, width);
    for (int i = 0; i < 700; ++i) {
      const double x = random.in(-0.2, 0.2), y = random.in(-0.2, 0.3), size = random.in(0, 0.02);
      paths.push_back(testing::closed(testing::box(x, y, x + size, y + size)));
    }
    EXPECT_GT(expect_all_found(strands_of(paths)), static_cast<std::size_t>(in_bundle) * in_bundle / 2) << seed;
  }
}

TEST(PairFinder, findsFans) {
  // All edges end in one vertex; and others end on the edges of the fan.
  Random random(6);
  std::vector<Path> paths;
  for (int i = 0; i < 700; ++i) {
    const Point tip{random.in(0, 4), random.in(-1, 1)};
    paths.push_back(edge({0, 0}, tip));
    if (i % 2 == 0) paths.push_back(edge({tip.x / 2, tip.y / 2}, {random.in(0, 4), random.in(-1, 1)}));
  }
  EXPECT_GT(expect_all_found(strands_of(paths)), 700u * 699 / 2);
}

TEST(PairFinder, findsTouchesOnALattice) {
  // Vertices on edges, collinear overlaps and copies: cuts run along edges that others only touch. Edges are clipped
  // many times at lines through their vertices, and must not lose them.
  Random random(7);
  for (const int size : {8, 20}) {
    std::vector<Path> paths;
    for (int i = 0; i < 900; ++i) {
      const auto point = [&] { return Point{1.0 * random.below(size), 1.0 * random.below(size)}; };
      const Point p = point(), q = point();
      if (p != q) paths.push_back(edge(p, q));
    }
    EXPECT_GT(expect_all_found(strands_of(paths)), 50000u);
  }
}

TEST(PairFinder, findsEdgesThatGoFromSideToSideOfTheirCells) {
  // Nested squares and a net of axis-parallel lines, some of them a little aslant: where cells are cut, most edges go
  // on through both halves.
  Random random(11);
  std::vector<Path> paths;
  for (int i = 1; i <= 300; ++i) paths.push_back(testing::closed(testing::box(-i, -i, i, i)));
  for (int i = -300; i <= 300; i += 3) {
    const double slant = i % 2 ? random.in(-0.01, 0.01) : 0;
    paths.push_back(edge({-310, i + 0.5}, {310, i + 0.5 + slant}));
    paths.push_back(edge({1.0 * i, -310}, {i + slant, 310}));
  }
  EXPECT_GT(expect_all_found(strands_of(paths)), 100000u);
}

TEST(PairFinder, findsCopies) {
  // No cut parts them: every pair is tested.
  const std::vector<Path> paths(700, edge({0, 0}, {3, 1}));
  EXPECT_EQ(expect_all_found(strands_of(paths)), 700u * 699 / 2);
  const std::vector<Path> points_apart(600, edge({0, 0}, {0, 1}));  // boxes without width
  EXPECT_EQ(expect_all_found(strands_of(points_apart)), 600u * 599 / 2);
}

TEST(PairFinder, findsTouchesAtCellBorders) {
  // Squares of a lattice: medians fall on the very lines where boxes touch.
  std::vector<Path> paths;
  for (int i = 0; i < 24; ++i)
    for (int j = 0; j < 24; ++j) paths.push_back(testing::closed(testing::box(i, j, i + 1, j + 1)));
  EXPECT_GT(expect_all_found(strands_of(paths)), 5000u);
}

TEST(PairFinder, passesOverPairsOfOneGroup) {
  Random random(8);
  std::vector<Path> paths;
  for (int i = 0; i < 800; ++i) paths.push_back(edge({random.unit(), random.unit()}, {random.unit(), random.unit()}));
  Strands strands = strands_of(paths, {1, 0}, 5);
  EXPECT_TRUE(visited(strands, monotone_runs(strands, Grouping::by_strand)).empty());
  for (std::size_t s = 0; s < strands.size(); ++s) strands.group[s] = static_cast<Group>(random.below(3));
  EXPECT_GT(expect_all_found(strands), 1000u);
  for (const EdgePair pair : visited(strands, monotone_runs(strands, Grouping::by_strand))) {
    const Group p = strands.group[(pair >> 32) / 2], q = strands.group[(pair & 0xffffffff) / 2];
    ASSERT_TRUE(p != q || p == any_group);
  }
}

}  // namespace
}  // namespace oblast::internal::noding
