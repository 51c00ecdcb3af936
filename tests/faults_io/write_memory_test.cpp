// Lets every single allocation fail while a result is written. Nothing leaks, the folder has the unchanged old file or
// the complete new one, and no other file remains.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "faults/every_allocation.h"
#include "io/write.h"

namespace oblast::testing {
namespace {

namespace fs = std::filesystem;

class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("oblast-faults-" + std::to_string(::getpid()))) {
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string file(const std::string& name) const { return (path_ / name).string(); }
  std::ptrdiff_t size() const { return std::distance(fs::directory_iterator(path_), {}); }

 private:
  fs::path path_;
};

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class OutOfMemoryWriting : public ::testing::TestWithParam<const char*> {};

TEST_P(OutOfMemoryWriting, leavesTheOldFileOrTheNewOneWhole) {
  const Folder folder;
  const std::string path = folder.file(std::string("out.") + GetParam());
  const RegionSet old_regions{{{0, 0}, {1, 0}, {0, 1}}, {3}, {1}};
  const RegionSet new_regions{{{0, 0}, {3, 0}, {0, 3}, {5, 5}, {7, 5}, {5, 9}}, {3, 6}, {1, 2}};
  io::WriteOptions overwrite;
  overwrite.existing = io::Existing::overwrite;
  io::write(path, new_regions, overwrite);
  const std::string new_text = text_of(path);
  io::write(path, old_regions, overwrite);
  const std::string old_text = text_of(path);
  const std::ptrdiff_t files = folder.size();

  const auto call = [&] {
    io::write(path, new_regions, overwrite);
    return text_of(path) == new_text;
  };
  fail_every_allocation(call, [&] {
    const std::string left = text_of(path);
    ASSERT_TRUE(left == old_text || left == new_text) << left;
    ASSERT_EQ(folder.size(), files) << "something was left in the folder";
    io::write(path, old_regions, overwrite);
  });
}

INSTANTIATE_TEST_SUITE_P(Formats, OutOfMemoryWriting, ::testing::Values("wkt", "geojson"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace oblast::testing
