// Pieces that lie between the same two vertices: found once, tested once, and given the same cuts.
#include "noding/repeated_pieces.h"

#include <gtest/gtest.h>

#include <atomic>

#include "noding/meetings.h"
#include "noding/node.h"
#include "support/strands_of.h"

namespace oblast::internal::noding {
namespace {

using testing::strands_of;

EdgeCut cut(std::uint32_t edge, const Point& at) { return {edge, 0, at}; }

TEST(RepeatedPieces, areFoundInEitherDirectionAmongMovedEdges) {
  Strands strands = strands_of({{{0, 0}, {1, 0}, {2, 0}}, {{2, 0}, {1, 0}}, {{0, 0}, {1, 0}}, {{1, 0}, {2, 0}}});
  for (const std::uint32_t edge : {0, 1, 3, 7}) strands.flags[edge] = moved_flag;
  strands.flags[5] = near_flag;  // identical to edge 0, but no piece of the last round
  const LargeArray<RepeatedPiece> repeated = flag_repeated_pieces(strands);
  ASSERT_EQ(repeated.size(), 2U);
  EXPECT_EQ(repeated[0].edge, 3U);
  EXPECT_EQ(repeated[0].first, 1U);
  EXPECT_EQ(repeated[1].edge, 7U);
  EXPECT_EQ(repeated[1].first, 1U);
  constexpr std::uint8_t moved_node = moved_flag | node_flag, again = moved_node | repeated_flag;
  EXPECT_EQ(strands.flags,
            (Array<std::uint8_t>{moved_flag, moved_node, node_flag, again, node_flag, near_flag, 0, again, node_flag}));
}

TEST(RepeatedPieces, getTheCutsOfTheFirstAlongTheirOwnDirection) {
  const Strands strands = strands_of({{{0, 0}, {9, 0}}, {{5, 5}, {6, 6}}, {{9, 0}, {0, 0}}, {{0, 0}, {9, 0}}});
  const std::vector<RepeatedPiece> repeated = {{4, 0}, {6, 0}};
  LargeArray<EdgeCut> cuts = {cut(0, {2, 0}), cut(0, {3, 0}), cut(2, {5.5, 5.5})};
  copy_cuts(strands, repeated, cuts);
  std::vector<std::pair<std::uint32_t, double>> found;
  for (const EdgeCut& c : cuts) found.emplace_back(c.edge, c.at.x);
  EXPECT_EQ(found,
            (std::vector<std::pair<std::uint32_t, double>>{{0, 2}, {0, 3}, {2, 5.5}, {4, 3}, {4, 2}, {6, 2}, {6, 3}}));
}

/// Calls of the checkpoint, one for so many pairs of runs, while squares that overlap along one line are noded.
int calls_for_squares(int count) {
  std::vector<testing::Path> squares;
  for (int i = 0; i < count; ++i) squares.push_back(testing::closed(testing::box(i, 0, i + count, 1)));
  NodingReport report;
  std::atomic<int> calls = 0;
  const Strands noded = node(strands_of(squares), report, [&] { ++calls; });
  // Both long sides of a square are cut at the sides of all others that end inside.
  EXPECT_EQ(noded.points.size(), squares.size() * 5 + report.cuts);
  EXPECT_EQ(report.cuts, 2U * static_cast<unsigned>(count) * static_cast<unsigned>(count - 1));
  return calls;
}

// The pieces are quadratic in the squares, and so is the work. It was cubic once: eight times the pairs.
TEST(RepeatedPieces, ofSquaresAlongOneLineMakeQuadraticWork) {
  const int few = calls_for_squares(100), many = calls_for_squares(200);
  EXPECT_LT(many, 6 * few) << few << " and " << many << " calls";
}

}  // namespace
}  // namespace oblast::internal::noding
