#include "scratch_folder.h"

#include <unistd.h>

#include <string>

namespace oblast::fuzz {
namespace {

namespace fs = std::filesystem;

struct Folder {
  fs::path path = fs::temp_directory_path() / ("oblast-fuzzer-" + std::to_string(getpid()));

  Folder() {
    fs::remove_all(path);
    fs::create_directories(path);
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

}  // namespace

const fs::path& scratch_folder() {
  static const Folder folder;
  return folder.path;
}

void empty_scratch_folder() {
  for (const fs::directory_entry& entry : fs::directory_iterator(scratch_folder())) fs::remove_all(entry.path());
}

}  // namespace oblast::fuzz
