// A file is written completely or not at all: what is refused before, and what remains after a failure.
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "io/staged_output.h"
#include "io_support.h"
#include "support/full_disk.h"

namespace oblast::io {
namespace {

namespace fs = std::filesystem;

const WriteOptions overwrite{Existing::overwrite, {}, {}};

class Writing : public FolderTest, public ::testing::WithParamInterface<const char*> {
 protected:
  std::string name() const { return std::string("out") + GetParam(); }
  std::string out() const { return path(name()); }
};

TEST_P(Writing, ExistingFileIsKeptUnlessOverwritten) {
  write(out(), one_triangle());
  const std::string before = contents(name());
  EXPECT_TRUE(mentions(write_error(out(), square_with_hole()), {name(), "exists already"}));
  EXPECT_THROW(check_writable(out()), IoError);
  EXPECT_EQ(contents(name()), before);
  write(out(), square_with_hole(), overwrite);
  EXPECT_TRUE(same_bits(read_file(out()).regions, square_with_hole()));
}

TEST_P(Writing, NothingElseIsLeftBehind) {
  write(out(), one_triangle());
  for (const std::string& entry : names()) EXPECT_EQ(entry.substr(0, 4), "out.") << entry;
  const bool is_set = std::string(GetParam()) == ".shp";
  EXPECT_EQ(names().size(), is_set ? 3U : 1U);
}

TEST_P(Writing, FullDiskLeavesTheOldFileUntouched) {
  write(out(), one_triangle());
  const auto names_before = names();
  std::vector<std::string> before;
  for (const std::string& entry : names_before) before.push_back(contents(entry));
  const RegionSet large = scattered(20000, 4);
  // From the first to the last byte: the failure must be detected at any point.
  for (const rlim_t bytes : {1000, 100000, 180000, 500000}) {
    const test::FullDisk disk(bytes);
    const std::string error = write_error(out(), large, overwrite);
    EXPECT_TRUE(mentions(error, {"cannot write", name()})) << bytes << ": " << error;
    EXPECT_EQ(names(), names_before);
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(contents(names_before[i]), before[i]);
  }
}

TEST_P(Writing, LastBytesMissingAreNoticed) {
  const RegionSet regions = scattered(300, 4);
  write(out(), regions);
  const auto size = static_cast<rlim_t>(fs::file_size(out()));
  fs::remove(out());
  for (const char* extension : {".shx", ".dbf", ".cpg"}) fs::remove(path(std::string("out") + extension));
  {
    const test::FullDisk disk(size - 1);
    EXPECT_NE(write_error(out(), regions), "");
    EXPECT_TRUE(names().empty()) << names().front();
  }
  EXPECT_EQ(write_error(out(), regions), "");
}

INSTANTIATE_TEST_SUITE_P(Formats, Writing, ::testing::Values(".shp", ".gpkg", ".geojson", ".fgb", ".wkt"),
                         [](const auto& suite) { return std::string(suite.param).substr(1); });

using WriteCall = FolderTest;

TEST_F(WriteCall, UnknownFormatsListTheKnownOnes) {
  for (const char* name : {"out.tif", "out.topojson", "out"}) {
    EXPECT_TRUE(mentions(write_error(path(name), one_triangle()), {name, ".shp .gpkg .geojson .fgb .wkt"}));
  }
  EXPECT_TRUE(names().empty());
}

TEST_F(WriteCall, MissingFolderAndFolderAsTarget) {
  EXPECT_TRUE(mentions(write_error(path("no/out.shp"), one_triangle()), {"no folder", "no"}));
  file("plain", "x");
  EXPECT_TRUE(mentions(write_error(path("plain/out.shp"), one_triangle()), {"plain"}));
  fs::create_directory(path("out.gpkg"));
  EXPECT_TRUE(mentions(write_error(path("out.gpkg"), one_triangle(), overwrite), {"out.gpkg", "folder"}));
}

TEST_F(WriteCall, UnwritableFolder) {
  // Not even the superuser can make files in /proc.
  EXPECT_TRUE(mentions(write_error("/proc/out.gpkg", one_triangle()), {"cannot write into /proc"}));
}

TEST_F(WriteCall, APartOfAnOldShapefileCountsAsExisting) {
  file("out.dbf", "someone's table");
  EXPECT_TRUE(mentions(write_error(path("out.shp"), one_triangle()), {"out.dbf", "exists already"}));
  EXPECT_EQ(contents("out.dbf"), "someone's table");
}

TEST_F(WriteCall, OverwritingLeavesNoPartOfTheOldShapefile) {
  file("out.prj", "an old coordinate system");
  file("out.qix", "an index of the old shapes");
  file("out.txt", "the user's notes");
  write(path("out.shp"), one_triangle(), overwrite);
  EXPECT_FALSE(exists("out.prj"));
  EXPECT_FALSE(exists("out.qix"));
  EXPECT_EQ(contents("out.txt"), "the user's notes");
  EXPECT_EQ(read_file(path("out.shp")).crs_wkt, "");
}

TEST_F(WriteCall, OverwritingLeavesNoJournalOfTheOldDatabase) {
  file("out.gpkg-wal", "old");
  write(path("out.gpkg"), one_triangle(), overwrite);
  EXPECT_EQ(names(), (std::vector<std::string>{"out.gpkg"}));
}

TEST_F(WriteCall, ASymbolicLinkStaysOne) {
  file("real.wkt", "old");
  fs::create_symlink(path("real.wkt"), path("link.wkt"));
  EXPECT_NE(write_error(path("link.wkt"), one_triangle()), "");
  write(path("link.wkt"), one_triangle(), overwrite);
  EXPECT_TRUE(fs::is_symlink(path("link.wkt")));
  EXPECT_EQ(contents("real.wkt"), to_wkt(one_triangle()) + "\n");
}

TEST_F(WriteCall, UpperCaseExtension) {
  write(path("out.SHP"), one_triangle());
  EXPECT_TRUE(same_bits(read_file(path("out.shp")).regions, one_triangle()));
  write(path("out.GPKG"), one_triangle());
  EXPECT_TRUE(same_bits(read_file(path("out.GPKG")).regions, one_triangle()));
}

TEST_F(WriteCall, InterruptionRemovesWhatIsUnderWay) {
  file("out.shp", "old");
  {
    const StagedOutput stage(path("out.shp"), {{".dbf", ".shx", ""}, {}, {}});
    const std::string folder = fs::path(stage.path()).parent_path().filename().string();
    file(folder + "/out.shp", "half");
    file(folder + "/out.dbf", "half");
    ASSERT_EQ(names().size(), 2U);
    discard_unfinished();
    EXPECT_EQ(names(), (std::vector<std::string>{"out.shp"}));
  }
  EXPECT_EQ(contents("out.shp"), "old");
  discard_unfinished();  // nothing is under way: nothing happens
  EXPECT_EQ(contents("out.shp"), "old");
}

TEST_F(WriteCall, AfterACommitOutputsAreStoppedOnlyIfMoreFollow) {
  write(path("out.wkt"), one_triangle());
  EXPECT_FALSE(stop_outputs());
  expect_more_output();
  // In a child: stop_outputs() is the beginning of the end.
  EXPECT_EXIT(std::_Exit(stop_outputs() ? 0 : 1), ::testing::ExitedWithCode(0), "");
}

TEST_F(WriteCall, AStoppedOutputNeverReplacesTheOldOne) {
  file("out.wkt", "old");
  const auto write_after_stop = [&] {
    std::thread other([&] { write(path("out.wkt"), one_triangle(), overwrite); });
    std::this_thread::sleep_for(std::chrono::milliseconds(200));  // the other thread waits before its commit
    std::_Exit(0);
  };
  EXPECT_EXIT(
      {
        if (!stop_outputs()) std::_Exit(1);
        write_after_stop();
      },
      ::testing::ExitedWithCode(0), "");
  EXPECT_EQ(contents("out.wkt"), "old");
}

TEST_F(WriteCall, StandardOutputGetsWkt) {
  ::testing::internal::CaptureStdout();
  write("-", one_triangle());
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "MULTIPOLYGON (((0 0, 4 0, 0 3, 0 0)))\n");
}

}  // namespace
}  // namespace oblast::io
