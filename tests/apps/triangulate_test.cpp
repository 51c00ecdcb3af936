// `oblast triangulate` as a user runs it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "apps/program_run.h"

namespace oblast::test {
namespace {

constexpr const char* square_with_hole =
    "MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9), (2 2, 2 7, 7 7, 7 2)), ((3 3, 5 3, 5 5, 3 5)))";

double area_of(const nlohmann::json& feature) {
  double sum = 0;
  const auto& ring = feature["geometry"]["coordinates"][0];
  for (std::size_t i = 0; i + 1 < ring.size(); ++i)
    sum += ring[i][0].get<double>() * ring[i + 1][1].get<double>() -
           ring[i + 1][0].get<double>() * ring[i][1].get<double>();
  return sum / 2;
}

/// Area by the attribute `polygon`, from -1 to 1.
std::vector<double> areas(const std::string& text) {
  std::vector<double> sums(3, 0);
  const auto file = nlohmann::json::parse(text);
  for (const auto& feature : file["features"]) {
    EXPECT_EQ(feature["geometry"]["coordinates"][0].size(), 4u);
    sums.at(feature["properties"]["polygon"].get<int>() + 1) += area_of(feature);
  }
  return sums;
}

TEST(TriangulateCommand, writesTrianglesWithTheirPolygon) {
  const Folder folder;
  const std::string output = folder.path("t.geojson");
  const ProgramRun run = oblast_program({"triangulate", "-", "-o", output, "--json"}, square_with_hole);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(areas(read_file(output)), (std::vector<double>{0, 81 - 25, 4}));
  const auto summary = nlohmann::json::parse(run.out);
  EXPECT_EQ(summary["polygons"], 2);
  EXPECT_EQ(summary["vertices"], 12);
  EXPECT_EQ(summary["triangles"], 10);
}

TEST(TriangulateCommand, goesUpToTheHullWhenAsked) {
  const Folder folder;
  const std::string output = folder.path("t.geojson");
  ASSERT_EQ(oblast_program({"triangulate", "-", "-o", output, "--hull", "-q"}, square_with_hole).code, 0);
  EXPECT_EQ(areas(read_file(output)), (std::vector<double>{25 - 4, 81 - 25, 4}));
}

TEST(TriangulateCommand, refusesBadDataAndLeavesNothing) {
  const Folder folder;
  const ProgramRun run =
      oblast_program({"triangulate", "-", "-o", folder.path("t.geojson")}, "POLYGON ((0 0, 1 0, nan 1, 0 0))");
  EXPECT_EQ(run.code, 1);
  EXPECT_FALSE(run.err.empty());
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace oblast::test
