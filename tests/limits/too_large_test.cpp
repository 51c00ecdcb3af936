// If there are more vertices than a call allows, the number alone is refused, before anything is read. The largest
// allowed number is not refused.
#include <gtest/gtest.h>
#include <oblast/classics.h>
#include <oblast/hull.h>
#include <oblast/layers.h>
#include <oblast/overlay.h>
#include <oblast/triangulate.h>

#include <optional>
#include <string>

#include "base/index.h"
#include "support/reserved_points.h"

namespace oblast::internal {
namespace {

template <class Call>
std::optional<Error> error_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "nothing was refused";
  return {};
}

template <class Call>
ErrorCode code_of(const Call& call) {
  const std::optional<Error> error = error_of(call);
  return error ? error->code() : ErrorCode::cancelled;
}

// The offsets are wrong. So input that is not too large passes the check of its size, and is then refused for its
// offsets.
constexpr std::uint32_t wrong_end = 0;

RegionView with_wrong_offsets(std::span<const Point> points) { return {points, {&wrong_end, 1}, {}}; }

class TooLarge : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!points_.there()) GTEST_SKIP() << "no addresses for so many points";
  }

  testing::ReservedPoints points_{most_vertices + 1};
};

TEST_F(TooLarge, oneVertexMoreThanTheLimitIsRefusedByEveryFunction) {
  const RegionView most = with_wrong_offsets(points_.first(most_vertices));
  const RegionView more = with_wrong_offsets(points_.first(most_vertices + 1));
  const auto each = [](const RegionView& view, ErrorCode expected) {
    EXPECT_EQ(code_of([&] { unite(view); }), expected);
    EXPECT_EQ(code_of([&] { overlay(view, {}, Operation::difference); }), expected);
    EXPECT_EQ(code_of([&] { overlay({}, view, Operation::difference); }), expected);
    EXPECT_EQ(code_of([&] { hull(view); }), expected);
    EXPECT_EQ(code_of([&] { layers(view); }), expected);
    EXPECT_EQ(code_of([&] { triangulate(view); }), expected);
    TriangulateOptions taken_as_it_is;
    taken_as_it_is.input = TriangleInput::result;
    EXPECT_EQ(code_of([&] { triangulate(view, taken_as_it_is); }), expected);
    EXPECT_EQ(code_of([&] { ClipWindow{view}; }), expected);
    for (const ClassicMethod method : {ClassicMethod::orourke, ClassicMethod::sutherland_hodgman,
                                       ClassicMethod::weiler_atherton, ClassicMethod::margalit_knott})
      EXPECT_EQ(code_of([&] { classic(method, view, {}, Operation::intersection); }), expected);
  };
  each(more, ErrorCode::too_large);
  each(most, ErrorCode::bad_offsets);
}

TEST_F(TooLarge, theVerticesOfBothOperandsCountTogether) {
  const std::size_t half = most_vertices / 2;
  const RegionView a = with_wrong_offsets(points_.first(half));
  const RegionView rest = with_wrong_offsets(points_.first(most_vertices - half));
  const RegionView one_more = with_wrong_offsets(points_.first(most_vertices - half + 1));
  EXPECT_EQ(code_of([&] { overlay(a, one_more, Operation::unite); }), ErrorCode::too_large);
  EXPECT_EQ(code_of([&] { overlay(a, rest, Operation::unite); }), ErrorCode::bad_offsets);
}

TEST_F(TooLarge, theVerticesOfAWindowCountWithTheSubjects) {
  const ClipWindow window(0, 0, 1, 1);  // of four
  const RegionView most = with_wrong_offsets(points_.first(most_vertices - 4));
  const RegionView more = with_wrong_offsets(points_.first(most_vertices - 3));
  EXPECT_EQ(code_of([&] { window.clip(more); }), ErrorCode::too_large);
  EXPECT_EQ(code_of([&] { window.clip(most); }), ErrorCode::bad_offsets);
}

TEST_F(TooLarge, theMessageSaysOfWhatThereAreHowMany) {
  const std::optional<Error> error = error_of([&] { unite(with_wrong_offsets(points_.first(most_vertices + 1))); });
  ASSERT_TRUE(error);
  EXPECT_EQ(error->what(), "too large: more than " + std::to_string(most_vertices) + " vertices in one call");
}

TEST(CheckedIndex, takesTheLimitAndRefusesOneMore) {
  EXPECT_EQ(checked_index(most_indices, "cuts"), most_indices);
  EXPECT_EQ(code_of([] { checked_index(most_indices + 1, "cuts"); }), ErrorCode::too_large);
  EXPECT_EQ(checked_index(most_chains, "chains", most_chains), most_chains);
  EXPECT_EQ(code_of([] { checked_index(most_chains + 1, "chains", most_chains); }), ErrorCode::too_large);
  EXPECT_EQ(code_of([] { checked_index(std::size_t{1} << 40, "cuts"); }), ErrorCode::too_large);
}

}  // namespace
}  // namespace oblast::internal
