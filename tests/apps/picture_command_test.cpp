// --svg as a user gives it: formats by extension, standard output, names that are no UTF-8, what the scale bar says.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "apps/rows_support.h"
#include "io/picture_png.h"

namespace oblast::test {
namespace {

using Words = std::vector<std::string>;

class PictureOption : public ::testing::Test {
 protected:
  PictureOption() {
    write_file(folder_ / "a.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))");
    write_file(folder_ / "b.wkt", "POLYGON ((2 2, 6 2, 6 6, 2 6, 2 2))");
  }
  ProgramRun run(const std::string& a, const std::string& picture, const Words& more = {}) {
    Words words{"overlay",
                "intersection",
                folder_.path(a),
                folder_.path("b.wkt"),
                "-o",
                folder_.path("o.gpkg"),
                "--overwrite",
                "--svg",
                picture == "-" ? picture : folder_.path(picture)};
    words.insert(words.end(), more.begin(), more.end());
    return oblast_program(words);
  }
  Folder folder_;
};

TEST_F(PictureOption, TheResultIsFilled) {
  const ProgramRun done = run("a.wkt", "-");
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_TRUE(done.out.starts_with("<svg ") && done.out.ends_with("</svg>\n"));
  EXPECT_TRUE(contains(done.out, "<g fill=\"#0f9d76\" fill-opacity=\"0.75\"")) << done.out;
  EXPECT_TRUE(contains(done.out, ">1 unit</text>")) << done.out;
}

TEST_F(PictureOption, TheExtensionDecidesTheFormat) {
  if (io::can_draw_png()) {
    const ProgramRun done = run("a.wkt", "p.png");
    EXPECT_EQ(done.code, 0) << done.err;
    const std::string png = read_file(folder_ / "p.png");
    EXPECT_TRUE(png.starts_with("\x89PNG\r\n\x1a\n"));
    EXPECT_TRUE(contains(png.substr(png.size() - 12), "IEND"));
  } else {
    EXPECT_TRUE(contains(run("a.wkt", "p.png").err, "install it (package librsvg2-2), or choose .svg"));
  }
  for (const char* const name : {"p.jpeg", "p"}) {
    const ProgramRun refused = run("a.wkt", name);
    EXPECT_EQ(refused.code, 1);
    EXPECT_TRUE(contains(refused.err, "choose a name that ends in .svg or .png")) << refused.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / name));
  }
}

TEST_F(PictureOption, TwoThingsOnStandardOutputAreRefused) {
  EXPECT_EQ(run("a.wkt", "-", {"--json"}).code, 2);
  const ProgramRun both = oblast_program({"union", folder_.path("a.wkt"), "-o", "-", "--svg", "-"});
  EXPECT_EQ(both.code, 2);
  EXPECT_TRUE(contains(both.err, "both write to standard output")) << both.err;
}

// The name of a file may be any bytes; a picture is UTF-8.
TEST_F(PictureOption, NamesThatAreNotUtf8AreShown) {
  const std::string name = "a\xff<\xc3\xa9>.wkt";
  std::filesystem::rename(folder_ / "a.wkt", folder_ / name);
  const ProgramRun done = run(name, "-");
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_TRUE(contains(done.out, "intersection of a\xEF\xBF\xBD&lt;\xc3\xa9&gt;.wkt and b.wkt")) << done.out;
  EXPECT_FALSE(contains(done.out, "\xff"));
}

TEST_F(PictureOption, ALongTitleIsWrappedAndCut) {
  const std::string name = std::string(200, 'n') + ".wkt";
  std::filesystem::rename(folder_ / "a.wkt", folder_ / name);
  const ProgramRun done = run(name, "-");
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_TRUE(contains(done.out, "nnn\xE2\x80\xA6"));
  EXPECT_FALSE(contains(done.out, std::string(150, 'n')));
}

TEST_F(PictureOption, ThePictureOfADepthSaysDepthOnce) {
  const ProgramRun done = oblast_program(
      {"depth", folder_.path("a.wkt"), folder_.path("b.wkt"), "-o", folder_.path("o.gpkg"), "--svg", "-"});
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_TRUE(contains(done.out, ">depth of a.wkt and 1 more<")) << done.out;
}

TEST_F(PictureOption, TheScaleBarHasTheUnitOfTheCoordinateSystem) {
  write_layer(folder_ / "m.geojson", {square(4e6, 500, "")});
  EXPECT_TRUE(
      contains(oblast_program({"union", folder_.path("m.geojson"), "-o", folder_.path("u.gpkg"), "--svg", "-"}).out,
               " m</text>"));
  std::string text = R"({"type":"FeatureCollection","features":[)" + square(7, 2, "") + "]}";
  write_file(folder_ / "degrees.geojson", text);
  EXPECT_TRUE(contains(
      oblast_program({"union", folder_.path("degrees.geojson"), "-o", folder_.path("v.gpkg"), "--svg", "-"}).out,
      " km</text>"));
}

// A GeoJSON file without "crs" is in degrees by its definition; many have metres in it all the same.
TEST(Pictures, OfMetresThatAreCalledDegreesAreNotStretched) {
  const Folder folder;
  const auto picture = [&](const std::string& size) {
    const std::string ring = "[[0,0],[" + size + ",0],[" + size + "," + size + "],[0," + size + "],[0,0]]";
    write_file(folder / "a.geojson", R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},)"
                                     R"("geometry":{"type":"Polygon","coordinates":[)" +
                                         ring + "]}}]}");
    const ProgramRun run = oblast_program(
        {"union", folder.path("a.geojson"), "-o", "-", "-q", "--overwrite", "--svg", folder.path("a.svg")});
    EXPECT_EQ(contains(run.err, "latitude beyond 90 degrees"), size != "9") << run.err;
    return read_file(folder / "a.svg");
  };
  EXPECT_TRUE(contains(picture("9"), " km</text>"));
  EXPECT_FALSE(contains(picture("70000"), " km</text>"));
}

}  // namespace
}  // namespace oblast::test
