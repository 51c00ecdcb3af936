// `generate roads`: the number of segments, determinism, and what makes the lines a network.
#include "oblast/roads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "apps/program_run.h"
#include "oblast/fires_random.h"

namespace oblast::test {
namespace {

using app::RoadNetwork;

constexpr std::uint64_t fingerprint_of_seed_7 = 3724048648357606197;

std::uint64_t fingerprint(const RoadNetwork& network) {
  std::uint64_t hash = 0;
  for (const Point& p : network.vertices) {
    std::uint64_t bits[2];
    std::memcpy(bits, &p, sizeof bits);
    hash = app::mix(app::mix(hash, bits[0]), bits[1]);
  }
  for (const std::uint32_t end : network.ends) hash = app::mix(hash, end);
  return hash;
}

TEST(Roads, ExactlyAsManySegmentsAsAskedFor) {
  for (const std::uint32_t segments : {1U, 2U, 299U, 700U, 12'345U, 100'000U}) {
    const RoadNetwork network = app::generate_roads(segments, 1);
    EXPECT_EQ(network.segments(), segments);
    EXPECT_EQ(network.kinds.size(), network.ends.size());
    std::uint32_t begin = 0;
    for (const std::uint32_t end : network.ends) {
      ASSERT_GE(end, begin + 2);
      for (std::uint32_t v = begin; v + 1 < end; ++v) ASSERT_NE(network.vertices[v], network.vertices[v + 1]);
      begin = end;
    }
  }
}

TEST(Roads, SameSeedSameBytesOnEveryMachine) {
  EXPECT_EQ(fingerprint(app::generate_roads(5'000, 7)), fingerprint_of_seed_7);
  EXPECT_NE(fingerprint(app::generate_roads(5'000, 8)), fingerprint_of_seed_7);
}

// Junctions have three or more ends and streets; without them there is no network. Roads are long and winding.
TEST(Roads, StreetsMeetAndRoadsWind) {
  const RoadNetwork network = app::generate_roads(20'000, 3);
  std::map<std::pair<double, double>, int> times;
  for (const Point& p : network.vertices) ++times[{p.x, p.y}];
  const auto shared = std::count_if(times.begin(), times.end(), [](const auto& place) { return place.second >= 2; });
  EXPECT_GT(shared, 4'000);
  double road_length = 0, road_chord = 0;
  std::uint32_t begin = 0;
  for (std::size_t line = 0; line < network.ends.size(); ++line) {
    const std::uint32_t end = network.ends[line];
    if (network.kinds[line] == "road") {
      for (std::uint32_t v = begin; v + 1 < end; ++v)
        road_length += std::hypot(network.vertices[v + 1].x - network.vertices[v].x,
                                  network.vertices[v + 1].y - network.vertices[v].y);
      road_chord += std::hypot(network.vertices[end - 1].x - network.vertices[begin].x,
                               network.vertices[end - 1].y - network.vertices[begin].y);
    }
    begin = end;
  }
  EXPECT_GT(road_chord, 100'000);
  EXPECT_GT(road_length, 1.05 * road_chord);
  EXPECT_LT(road_length, 1.6 * road_chord);
}

TEST(Roads, TheProgramWritesThemInEachFormat) {
  const Folder folder;
  for (const std::string extension : {".gpkg", ".geojson", ".shp", ".fgb", ".wkt"}) {
    const std::string out = folder.path("roads" + extension);
    const ProgramRun made = oblast_program({"generate", "roads", "-n", "900", "-o", out});
    EXPECT_EQ(made.code, 0) << made.err;
    EXPECT_TRUE(contains(made.err, "900 segments")) << made.err;
    EXPECT_EQ(oblast_program({"generate", "roads", "-n", "900", "-o", out}).code, 1) << "must not replace";
    const ProgramRun zone =
        oblast_program({"buffer", out, "--distance", "20", "-o", folder.path("zone.wkt"), "--overwrite"});
    EXPECT_EQ(zone.code, 0) << zone.err;
    EXPECT_TRUE(contains(zone.err, "lines")) << zone.err;
  }
  EXPECT_TRUE(contains(read_file(folder / "roads.geojson"), "\"kind\": \"street\""));
  const ProgramRun text = oblast_program({"generate", "roads", "-n", "3", "-o", "-"});
  EXPECT_TRUE(text.out.starts_with("LINESTRING (")) << text.out;
  EXPECT_EQ(oblast_program({"generate", "roads", "-n", "3", "-o", folder.path("a.csv")}).code, 1);
  EXPECT_EQ(oblast_program({"generate", "roads", "-n", "0", "-o", folder.path("a.gpkg")}).code, 2);
}

}  // namespace
}  // namespace oblast::test
