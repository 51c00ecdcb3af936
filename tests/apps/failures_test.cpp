// Failures as a user sees them: bad files, full disks and interrupts. Each has its message and its exit code, leaves
// the old output unchanged, and leaves no unfinished file.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>

#include "apps/program_run.h"
#include "generators/random.h"
#include "support/full_disk.h"

namespace oblast::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr const char* square = "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))";
constexpr const char* formats[] = {"shp", "gpkg", "geojson", "fgb", "wkt"};

void expect_mentions(const std::string& text, const Words& words) {
  for (const std::string& word : words) EXPECT_NE(text.find(word), std::string::npos) << word << " is not in " << text;
}

/// A folder whose files must not change, byte for byte.
class Kept {
 public:
  explicit Kept(const Folder& folder) : folder_(folder), names_(folder.names()) {
    for (const std::string& name : names_) contents_.push_back(read_file(folder / name));
  }
  void expect_unchanged() const {
    EXPECT_EQ(folder_.names(), names_);
    for (std::size_t i = 0; i < names_.size(); ++i)
      EXPECT_TRUE(read_file(folder_ / names_[i]) == contents_[i]) << names_[i] << " has changed";
  }

 private:
  const Folder& folder_;
  Words names_;
  Words contents_;
};

/// Expects that the program fails with exit code 1 and a message, and does not change the folder.
void expect_refused(const Folder& folder, Words call, const Words& mentioned, const std::string& input = {}) {
  const Kept kept(folder);
  call.insert(call.end(), {"-o", folder.path("out.wkt")});
  const ProgramRun run = oblast_program(call, input);
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_EQ(run.out, "");
  expect_mentions(run.err, mentioned);
  kept.expect_unchanged();
}

std::string feature(const std::string& coordinates) {
  return R"({"type":"Feature","properties":{},"geometry":{"type":"MultiPolygon","coordinates":)" + coordinates + "}}";
}

/// Three features; the bad number is y of vertex 1, in ring 2 of part 2 of the last one.
std::string geojson_with(const std::string& number) {
  const std::string good = feature("[[[[0,0],[1,0],[0,1],[0,0]]]]");
  const std::string bad =
      feature("[[[[0,0],[1,0],[0,1],[0,0]]],[[[0,0],[9,0],[9,9],[0,0]],[[5,1],[6," + number + "],[6,2],[5,1]]]]");
  return R"({"type":"FeatureCollection","features":[)" + good + "," + good + "," + bad + "]}";
}

TEST(BadCoordinates, areNamedWithFileFeaturePartAndVertex) {
  const Folder folder;
  const std::pair<std::string, std::string> numbers[] = {{"NaN", "not a number"}, {"1e999", "infinite"},
                                                         {"-1e999", "infinite"},  {"1e91", "domain"},
                                                         {"-1e91", "domain"},     {"1e-91", "domain"}};
  for (const auto& [number, said] : numbers) {
    write_file(folder / "layer.geojson", geojson_with(number));
    expect_refused(folder, {"union", folder.path("layer.geojson")},
                   {"layer.geojson", "feature 2", "part 2", "ring 2", "vertex 1", said});
    // Also as the second operand.
    expect_refused(folder, {"overlay", "difference", "-", folder.path("layer.geojson")},
                   {"layer.geojson", "feature 2", "vertex 1", said}, square);
  }
  write_file(folder / "layer.geojson", geojson_with("1e90"));
  EXPECT_EQ(oblast_program({"union", folder.path("layer.geojson"), "-o", folder.path("out.wkt")}).code, 0);
}

/// Writes squares.shp and its companions into the folder.
void write_shapefile(const Folder& folder) {
  std::string many = "MULTIPOLYGON (";
  for (int i = 0; i < 40; ++i) {
    const auto x = std::to_string(3 * i), x1 = std::to_string(3 * i + 1);
    many += (i ? ", ((" : "((") + x + " 0, " + x1 + " 0, " + x1 + " 1, " + x + " 0))";
  }
  ASSERT_EQ(oblast_program({"union", "-", "-o", folder.path("squares.shp"), "-q"}, many + ")").code, 0);
}

TEST(BadFiles, aTruncatedShapefileIsAnError) {
  const Folder folder;
  write_shapefile(folder);
  const auto size = fs::file_size(folder / "squares.shp");
  for (const auto kept : {size - 1, size / 2, std::uintmax_t{100}, std::uintmax_t{60}, std::uintmax_t{0}}) {
    fs::resize_file(folder / "squares.shp", kept);
    expect_refused(folder, {"union", folder.path("squares.shp")}, {"squares.shp"});
  }
}

TEST(BadFiles, aShapefileWithoutItsIndexIsAnError) {
  const Folder folder;
  write_shapefile(folder);
  fs::remove(folder / "squares.shx");
  expect_refused(folder, {"union", folder.path("squares.shp")}, {"squares.shp", ".shx"});
}

TEST(BadFiles, whatIsNoVectorFileIsAnError) {
  const Folder folder;
  for (const char* name : {"a.png", "a.gpkg", "a.geojson", "a.fgb", "a.shp", "a.wkt", "a"}) {
    write_file(folder / name, "\x89PNG\r\n, or rather just some text\n");
    expect_refused(folder, {"union", folder.path(name)}, {name});
    fs::remove(folder / name);
  }
  expect_refused(folder, {"union", "-"}, {"standard input"}, "this is no polygon");
}

TEST(BadOutputs, areToldBeforeTheWorkAndLeaveNothing) {
  const Folder folder;
  write_file(folder / "plain", "a file");
  const Kept kept(folder);
  for (const char* extension : formats) {
    for (const std::string& target : {folder.path("none/out."), folder.path("plain/out."), std::string("/proc/out.")}) {
      const ProgramRun run = oblast_program({"union", "-", "-o", target + extension}, square);
      EXPECT_EQ(run.code, 1) << target << extension;
      EXPECT_NE(run.err, "");
    }
  }
  kept.expect_unchanged();
}

TEST(ExistingOutput, isKeptUnlessOverwriteIsSaid) {
  for (const std::string extension : formats) {
    const Folder folder;
    const std::string out = folder.path("out." + extension);
    ASSERT_EQ(oblast_program({"union", "-", "-o", out, "-q"}, square).code, 0);
    const Kept kept(folder);
    const std::string other = "POLYGON ((0 0, 1 0, 1 1, 0 0))";
    const ProgramRun refused = oblast_program({"union", "-", "-o", out}, other);
    EXPECT_EQ(refused.code, 1);
    expect_mentions(refused.err, {"out." + extension, "--overwrite"});
    kept.expect_unchanged();
    EXPECT_EQ(oblast_program({"union", "-", "-o", out, "--overwrite", "-q"}, other).code, 0);
    EXPECT_NE(oblast_program({"union", out, "-o", "-", "-q"}).out.find("1 1"), std::string::npos);
  }
}

/// Triangles with about a million crossings: some seconds of work, and a result of many megabytes.
std::string many_triangles(int count) {
  generators::Random random(1);
  std::string text = "MULTIPOLYGON (";
  for (int i = 0; i < count; ++i) {
    const auto vertex = [&] { return std::to_string(random.in(0, 100)) + " " + std::to_string(random.in(0, 100)); };
    const std::string first = vertex();
    text += (i ? ", ((" : "((") + first + ", " + vertex() + ", " + vertex() + ", " + first + "))";
  }
  return text + ")";
}

TEST(FullDisk, leavesTheOldOutputAlone) {
  const std::string triangles = many_triangles(200);  // with even_odd the result has some hundred kilobytes
  for (const std::string extension : formats) {
    const Folder folder;
    const std::string out = folder.path("out." + extension);
    ASSERT_EQ(oblast_program({"union", "-", "-o", out, "-q"}, square).code, 0);
    const Kept kept(folder);
    for (const rlim_t bytes : {10'000, 100'000}) {
      const FullDisk disk(bytes);
      const ProgramRun run = oblast_program({"union", "-", "-o", out, "--overwrite", "--fill", "evenodd"}, triangles);
      EXPECT_EQ(run.code, 1) << extension << ": " << run.err;
      expect_mentions(run.err, {"out." + extension});
      kept.expect_unchanged();
    }
    EXPECT_EQ(oblast_program({"union", "-", "-o", out, "--overwrite", "--fill", "evenodd"}, triangles).code, 0);
  }
}

TEST(FullDisk, isNoticedOnStandardOutput) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const Folder folder;
  write_file(folder / "in.wkt", square);
  const std::string call = std::string("'") + OBLAST_PROGRAM + "' union '" + folder.path("in.wkt") +
                           "' -o - >/dev/full 2>'" + folder.path("err") + "'";
  const int status = std::system(call.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_NE(read_file(folder / "err"), "");
}

TEST(Interrupted, atWorkLeavesTheOldOutputAlone) {
  const std::string triangles = many_triangles(1500);
  for (const std::string extension : formats) {
    const Folder folder;
    const std::string out = folder.path("out." + extension);
    ASSERT_EQ(oblast_program({"union", "-", "-o", out, "-q"}, square).code, 0);
    const Kept kept(folder);
    const ProgramRun run =
        program_interrupted_at_work({"union", "-", "-o", out, "--overwrite", "--fill", "evenodd"}, triangles);
    EXPECT_EQ(run.code, 130) << run.err;
    expect_mentions(run.err, {"interrupted"});
    kept.expect_unchanged();
  }
}

// The signal may come during reading, overlay or writing. If it comes too late, the new output exists.
TEST(Interrupted, atAnyMomentLeavesTheOldOutputAloneOrTheNewOneWhole) {
  const Folder input;
  write_file(input / "in.wkt", many_triangles(400));
  const Words union_of_all = {"union", input.path("in.wkt"), "--overwrite", "--fill", "evenodd", "-o"};
  const auto call = [&](const std::string& out) {
    Words words = union_of_all;
    words.push_back(out);
    return words;
  };
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(oblast_program(call(input.path("whole.gpkg"))).code, 0);
  const auto whole =
      std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - begin).count();
  generators::Random random(5);
  int stopped = 0;
  for (const std::string extension : formats) {
    for (int trial = 0; trial < 4; ++trial) {
      const Folder folder;
      const std::string out = folder.path("out." + extension);
      ASSERT_EQ(oblast_program({"union", "-", "-o", out, "-q"}, square).code, 0);
      const Kept kept(folder);
      const std::vector<std::string> names = folder.names();
      const std::chrono::microseconds delay(static_cast<std::int64_t>(random.unit() * static_cast<double>(whole)));
      const ProgramRun run = program_interrupted_after(delay, call(out));
      if (run.code == 0) {
        EXPECT_EQ(folder.names(), names) << extension << " after " << delay.count() << " us";
        EXPECT_EQ(oblast_program({"check", out}).code, 0) << extension << " after " << delay.count() << " us";
        continue;
      }
      // -1: the signal came before the program handled signals.
      EXPECT_TRUE(run.code == 130 || run.code == -1) << run.code << ": " << run.err;
      kept.expect_unchanged();
      ++stopped;
    }
  }
  EXPECT_GT(stopped, 0);
}

}  // namespace
}  // namespace oblast::test
