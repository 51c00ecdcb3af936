// What a killed program leaves beside its target is removed by the next run that writes the same target, and by no
// other; what a living program is writing stays.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <chrono>

#include "apps/program_run.h"

namespace oblast::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr const char* square = "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))";

void make_stage(const Folder& folder, const std::string& name) {
  fs::create_directory(folder / name);
  write_file(folder / name / "b.gpkg", "half a file");
  write_file(folder / name / "b.gpkg-journal", "");
  fs::last_write_time(folder / name, fs::file_time_type::clock::now() - std::chrono::minutes(5));
}

TEST(Leftovers, OfTheSameTargetAreRemoved) {
  const Folder folder;
  for (const char* const name : {".b.gpkg.writing-Xk2f9a", ".b.gpkg.stopped-aaaaaa", ".c.gpkg.writing-Xk2f9a",
                                 ".b.gpkg.writing-longer-than-ours"})
    make_stage(folder, name);
  ASSERT_EQ(oblast_program({"union", "-", "-o", folder.path("b.gpkg"), "-q"}, square).code, 0);
  EXPECT_EQ(folder.names(), (Words{".b.gpkg.writing-longer-than-ours", ".c.gpkg.writing-Xk2f9a", "b.gpkg"}));
}

TEST(Leftovers, ThatAreInUseStay) {
  const Folder folder;
  make_stage(folder, ".b.gpkg.writing-Xk2f9a");
  const int stage = ::open(folder.path(".b.gpkg.writing-Xk2f9a").c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(::flock(stage, LOCK_SH | LOCK_NB), 0);  // as the program does while it writes
  EXPECT_EQ(oblast_program({"union", "-", "-o", folder.path("b.gpkg"), "-q"}, square).code, 0);
  EXPECT_EQ(folder.names(), (Words{".b.gpkg.writing-Xk2f9a", "b.gpkg"}));
  ::close(stage);
  EXPECT_EQ(oblast_program({"union", "-", "-o", folder.path("b.gpkg"), "-q", "--overwrite"}, square).code, 0);
  EXPECT_EQ(folder.names(), Words{"b.gpkg"});
}

TEST(Leftovers, OfGeneratedFiresAreRemoved) {
  const Folder folder;
  fs::create_directory(folder / "fires");
  make_stage(folder, "fires/.fires.writing-Xk2f9a");
  const Words call{"generate", "fires", "-o", folder.path("fires"), "--scale", "0.01", "--months", "10", "-q"};
  const int stage = ::open(folder.path("fires/.fires.writing-Xk2f9a").c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(::flock(stage, LOCK_SH | LOCK_NB), 0);  // as the program does while it writes
  const ProgramRun busy = oblast_program(call);
  EXPECT_EQ(busy.code, 1);
  EXPECT_TRUE(contains(busy.err, "is not empty")) << busy.err;
  ::close(stage);
  ASSERT_EQ(oblast_program(call).code, 0);
  EXPECT_GT(std::distance(fs::directory_iterator(folder / "fires"), fs::directory_iterator()), 3);
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / "fires"))
    EXPECT_TRUE(entry.path().filename().string().starts_with("fires-2011-")) << entry.path();
}

}  // namespace
}  // namespace oblast::test
