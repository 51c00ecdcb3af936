// `generate fires`: the counts of the paper, determinism, and contours like those of a vectoriser.
#include "oblast/fires.h"

#include <gtest/gtest.h>
#include <oblast/oblast.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "apps/program_run.h"
#include "oblast/fires_lattice.h"
#include "oblast/fires_random.h"
#include "verify/verify.h"

namespace oblast::test {
namespace {

using app::Cell;
using app::FirePass;

std::uint64_t fingerprint(const std::vector<FirePass>& passes) {
  std::uint64_t hash = 0;
  for (const FirePass& pass : passes) {
    for (const Point& p : pass.contours.points) {
      std::uint64_t bits[2];
      std::memcpy(bits, &p, sizeof bits);
      hash = app::mix(app::mix(hash, bits[0]), bits[1]);
    }
    for (const std::uint32_t end : pass.contours.contour_ends) hash = app::mix(hash, end);
  }
  return hash;
}

TEST(Fires, FullSizeIsTableOneToTheUnit) {
  std::map<int, std::array<std::size_t, 3>> counts;
  for (const FirePass& pass : app::generate_fires({})) {
    auto& [files, contours, vertices] = counts[std::stoi(pass.name.substr(11, 2))];
    ++files;
    contours += pass.contours.contour_ends.size();
    vertices += pass.contours.points.size();
    EXPECT_FALSE(pass.contours.empty()) << pass.name;
  }
  ASSERT_EQ(counts.size(), std::size(app::fire_months));
  for (const app::FireMonth& month : app::fire_months) {
    EXPECT_EQ(counts[month.month][0], static_cast<std::size_t>(month.files)) << month.month;
    EXPECT_EQ(counts[month.month][1], static_cast<std::size_t>(month.contours)) << month.month;
    EXPECT_EQ(counts[month.month][2], static_cast<std::size_t>(month.vertices)) << month.month;
  }
}

TEST(Fires, SameSeedSameBytes) {
  const app::FiresOptions options{7, 0.02, {}};
  EXPECT_EQ(fingerprint(app::generate_fires(options)), fingerprint(app::generate_fires(options)));
  EXPECT_NE(fingerprint(app::generate_fires(options)), fingerprint(app::generate_fires({8, 0.02, {}})));
}

TEST(Fires, AMonthIsTheSameAloneOrWithOthers) {
  const auto all = app::generate_fires({3, 0.02, {}}), july = app::generate_fires({3, 0.02, {7}});
  std::vector<FirePass> july_of_all;
  for (const FirePass& pass : all) {
    if (pass.name.substr(11, 2) == "07") july_of_all.push_back(pass);
  }
  EXPECT_EQ(fingerprint(july), fingerprint(july_of_all));
}

TEST(Fires, NamesAreTimesInOrder) {
  const auto passes = app::generate_fires({1, 1, {6}});
  for (std::size_t k = 1; k < passes.size(); ++k) ASSERT_LT(passes[k - 1].name, passes[k].name);
  EXPECT_EQ(passes.front().name.substr(0, 14), "fires-2011-06-");
}

TEST(Fires, ContoursAreSimpleAndInRussia) {
  for (const FirePass& pass : app::generate_fires({1, 0.05, {}})) {
    const RegionView view = pass.contours;
    for (std::size_t c = 0; c < view.contour_count(); ++c) {
      const std::vector<Point> points(view.contour(c).begin(), view.contour(c).end());
      const std::uint32_t end = static_cast<std::uint32_t>(points.size()), one = 1;
      const RegionView alone{points, {&end, 1}, {&one, 1}};
      const auto fault = verify::check_closed(alone);
      ASSERT_FALSE(fault) << pass.name << " contour " << c << ": " << fault->what;
      ASSERT_GT(signed_area(alone), 0);
      for (const Point& p : points) ASSERT_TRUE(p.x > 29 && p.x < 181 && p.y > 49 && p.y < 73);
    }
  }
}

TEST(Fires, MostlyQuadrilateralsSomeStaircases) {
  std::size_t quadrilaterals = 0, longer = 0, largest = 0;
  for (const FirePass& pass : app::generate_fires({1, 1, {6}})) {
    const RegionView view = pass.contours;
    for (std::size_t c = 0; c < view.contour_count(); ++c) {
      const std::size_t size = view.contour(c).size();
      ++(size == 4 ? quadrilaterals : longer);
      largest = std::max(largest, size);
    }
  }
  EXPECT_GT(quadrilaterals, 2 * longer);
  EXPECT_GT(longer, quadrilaterals / 10);
  EXPECT_GT(largest, 50u);
}

TEST(Fires, NeighboursShareCornersBitForBit) {
  std::size_t shared = 0;
  for (const FirePass& pass : app::generate_fires({1, 0.05, {}})) {
    std::vector<Point> points = pass.contours.points;
    std::sort(points.begin(), points.end(), lexicographically_less);
    // A pixel is some thousandths of a degree wide. Points that are much closer are meant to be one corner.
    constexpr double one_place = 1e-9;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = i + 1; j < points.size() && points[j].x - points[i].x < one_place; ++j) {
        if (std::abs(points[j].y - points[i].y) >= one_place) continue;
        ASSERT_EQ(points[i], points[j]) << pass.name;
        ++shared;
      }
    }
  }
  EXPECT_GT(shared, 0u) << "no pass has two contours that touch: this test says nothing";
}

TEST(FiresLattice, DiscsAreSortedAndHoldTheirCentre) {
  const app::Lattice lattice({101.3, 61.7}, 0.21, 1.37, 1.11);
  const Cell cell = lattice.cell_at({100.9, 62.4});
  const auto disc = lattice.disc({100.9, 62.4}, 0.05 + 1.37);
  EXPECT_NE(std::find(disc.begin(), disc.end(), cell), disc.end());
  EXPECT_TRUE(std::is_sorted(disc.begin(), disc.end()));
}

TEST(FiresLattice, OutlineOfAnL) {
  const std::vector<Cell> l{{0, 0}, {0, 1}, {1, 0}};
  std::vector<Cell> corners;
  for (const app::OutlineVertex& v : app::outline(l)) {
    if (!v.straight) corners.push_back(v.corner);
  }
  EXPECT_EQ(corners, (std::vector<Cell>{{2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 0}}));
  EXPECT_EQ(app::outline(l).size(), 8u);
}

TEST(FiresLattice, ComponentsHangTogetherBySides) {
  const auto parts = app::components({{0, 0}, {0, 1}, {1, 2}, {5, 5}});
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0], (std::vector<Cell>{{0, 0}, {0, 1}}));
}

TEST(FiresLattice, GapsAreFilled) {
  std::vector<Cell> ring;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (i != 1 || j != 1) ring.push_back({i, j});
    }
  }
  EXPECT_EQ(app::without_gaps(ring).size(), 9u);
}

TEST(FiresCommand, WritesShapefilesThatReadBack) {
  const Folder folder;
  const ProgramRun run = oblast_program(
      {"generate", "fires", "--month", "april", "--scale", "0.02", "-o", folder.path("fires"), "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json["files"], 9);
  EXPECT_EQ(json["contours"], 413);
  EXPECT_EQ(json["vertices"], 2048);
  std::set<std::string> shapes;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "fires")) {
    if (entry.path().extension() == ".shp") shapes.insert(entry.path().filename().string());
  }
  EXPECT_EQ(shapes.size(), 9u);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"fires"});
  const ProgramRun united = oblast_program({"union", folder.path("fires"), "-o", folder.path("burnt.gpkg"), "--json"});
  ASSERT_EQ(united.code, 0) << united.err;
  const auto summary = nlohmann::json::parse(united.out);
  EXPECT_EQ(summary["operands"][0]["files"], 9);
  EXPECT_EQ(summary["operands"][0]["vertices"], 2048);
  EXPECT_NE(summary["crs"].get<std::string>().find("WGS 84"), std::string::npos);
  EXPECT_EQ(oblast_program({"check", folder.path("burnt.gpkg"), "--canonical"}).code, 0);
}

TEST(FiresCommand, LeavesOtherFilesAlone) {
  const Folder folder;
  const std::string fires = folder.path("fires");
  std::filesystem::create_directory(fires);
  write_file(folder / "fires/notes.txt", "mine");
  const std::vector<std::string> words{"generate", "fires", "--month", "10", "--scale", "0.01", "-q", "-o", fires};
  EXPECT_EQ(oblast_program(words).code, 1);
  std::vector<std::string> forced = words;
  forced.push_back("--overwrite");
  EXPECT_EQ(oblast_program(forced).code, 0);
  EXPECT_EQ(read_file(folder / "fires/notes.txt"), "mine");
}

}  // namespace
}  // namespace oblast::test
