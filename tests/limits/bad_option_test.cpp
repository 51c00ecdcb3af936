// Every function that takes options and enumerators refuses values out of range, and names them.
#include <gtest/gtest.h>
#include <oblast/classics.h>
#include <oblast/hull.h>
#include <oblast/layers.h>
#include <oblast/overlay.h>
#include <oblast/triangulate.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "support/public_functions.h"

namespace oblast::testing {
namespace {

const RegionSet square{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {4}, {1}};

/// The message; empty if nothing or a different exception was thrown.
std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_option) << error.what();
    return error.what();
  }
  return "";
}

void expect_refused(const std::string& word, const std::function<void()>& call) {
  EXPECT_NE(refusal(call).find(word), std::string::npos) << word;
}

TEST(BadOption, threadsOutOfRangeAreRefusedByEveryFunction) {
  for (const PublicFunction& function : public_functions(square, square, square)) {
    if (!function.takes_options()) continue;
    for (const int threads : {-1, CallOptions::most_threads + 1, 100000, std::numeric_limits<int>::max()}) {
      CallOptions options;
      options.threads = threads;
      const std::string message = refusal([&] { function.call(options); });
      EXPECT_NE(message.find("threads is " + std::to_string(threads)), std::string::npos) << function.name;
      EXPECT_NE(message.find("1024"), std::string::npos) << function.name;
    }
  }
}

TEST(BadOption, asManyThreadsAsAreAllowedWork) {
  RegionSet many;
  for (int i = 0; i < 400; ++i) {
    for (const Point& p : square.points) many.points.push_back({p.x + i, p.y});
    many.contour_ends.push_back(static_cast<std::uint32_t>(many.points.size()));
  }
  Options options;
  options.threads = CallOptions::most_threads;
  EXPECT_EQ(unite(many, options), unite(many));
}

TEST(BadOption, enumeratorsOutOfRangeAreRefused) {
  for (const int number : {-1, 17, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}) {
    expect_refused("Operation(" + std::to_string(number) + ")",
                   [&] { overlay(square, square, static_cast<Operation>(number)); });
    for (const ClassicMethod method : {ClassicMethod::orourke, ClassicMethod::sutherland_hodgman,
                                       ClassicMethod::weiler_atherton, ClassicMethod::margalit_knott})
      expect_refused("Operation", [&] { classic(method, square, square, static_cast<Operation>(number)); });
    expect_refused("Operation", [&] { orourke(square, square, static_cast<Operation>(number)); });
    expect_refused("Operation", [&] { weiler_atherton(square, square, static_cast<Operation>(number)); });
    expect_refused("Operation", [&] { margalit_knott(square, square, static_cast<Operation>(number)); });
    expect_refused("ClassicMethod",
                   [&] { classic(static_cast<ClassicMethod>(number), square, square, Operation::intersection); });
    expect_refused("LayerRule", [&] { layers(square, static_cast<LayerRule>(number)); });
    TriangulateOptions extent, input;
    extent.extent = static_cast<TriangleExtent>(number);
    input.input = static_cast<TriangleInput>(number);
    expect_refused("TriangleExtent", [&] { triangulate(square, extent); });
    expect_refused("TriangleInput", [&] { triangulate(square, input); });
    const auto all_refuse = [&](const std::string& word, const std::function<void(Options&)>& set) {
      TriangulateOptions options;
      set(options);
      expect_refused(word, [&] { overlay(square, square, Operation::unite, options); });
      expect_refused(word, [&] { unite(square, options); });
      expect_refused(word, [&] { triangulate(square, options); });
    };
    all_refuse("FillRule::Kind", [&](Options& o) { o.fill_a.kind = static_cast<FillRule::Kind>(number); });
    all_refuse("FillRule::Kind", [&](Options& o) { o.fill_b.kind = static_cast<FillRule::Kind>(number); });
    all_refuse("Engine", [&](Options& o) { o.engine = static_cast<Engine>(number); });
    all_refuse("ContourConvention", [&](Options& o) { o.contours = static_cast<ContourConvention>(number); });
    all_refuse("CollinearVertices", [&](Options& o) { o.collinear = static_cast<CollinearVertices>(number); });
  }
}

TEST(BadOption, aDepthBelowOneIsRefused) {
  for (const int depth : {0, -1, std::numeric_limits<int>::min()}) {
    Options options;
    options.fill_a = FillRule::at_least(depth);
    expect_refused("depth", [&] { unite(square, options); });
    options.fill_a = {FillRule::Kind::polygons, depth};  // which it does not read
    EXPECT_EQ(unite(square, options), square);
  }
}

TEST(BadOffsets, areRefusedByTheFunctionsThatReadNoMore) {
  RegionSet past = square;
  past.contour_ends = {1000};
  try {
    signed_area(past);
    ADD_FAILURE() << "nothing was refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_offsets);
  }
}

TEST(BadCoordinates, ofAContourAreRefusedWithTheirVertex) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e300}) {
    std::vector<Point> contour = square.points;
    contour[2].y = bad;
    try {
      hull(contour);
      ADD_FAILURE() << "nothing was refused";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), std::isnan(bad) ? ErrorCode::not_finite : ErrorCode::out_of_domain);
      EXPECT_EQ(error.place().vertex, 2u);
    }
  }
}

}  // namespace
}  // namespace oblast::testing
