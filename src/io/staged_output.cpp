// Writing beside the target, renaming, and cleaning up; see staged_output.h.
#include "io/staged_output.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>

#include "io/layer.h"
#include "io/write.h"

namespace oblast::io {

namespace fs = std::filesystem;

// What discard_unfinished() removes. Made before writing begins, so that a signal handler finds the
// names ready: it may not allocate.
struct UnfinishedOutput {
  std::vector<std::string> files;
  std::string folder;
  UnfinishedOutput* next_abandoned = nullptr;
};

namespace {

// Outputs under way, a few at a time. One that finds no free slot is merely not discarded on interruption.
std::array<std::atomic<UnfinishedOutput*>, 64> unfinished_outputs;

std::atomic<UnfinishedOutput*> abandoned = nullptr;

void remember(UnfinishedOutput* output) {
  for (auto& slot : unfinished_outputs) {
    UnfinishedOutput* none = nullptr;
    if (slot.compare_exchange_strong(none, output)) return;
  }
}

// False when discard_unfinished() has taken it.
bool forget(UnfinishedOutput* output) {
  for (auto& slot : unfinished_outputs) {
    UnfinishedOutput* expected = output;
    if (slot.compare_exchange_strong(expected, nullptr)) return true;
  }
  return false;
}

// Allocates nothing: a signal handler and a destructor may call it. False when files of other names are there.
bool discard(const UnfinishedOutput& output) {
  for (const std::string& file : output.files) ::unlink(file.c_str());
  return ::rmdir(output.folder.c_str()) == 0;
}

// Files that a driver made without our knowing its names for them.
void remove_with_strangers(const std::string& folder) {
  try {
    std::error_code error;
    fs::remove_all(folder, error);
  } catch (const std::bad_alloc&) {  // from a destructor nobody could hear of it
  }
}

std::string part_of(const std::string& path, const std::string& part) {
  if (part.empty() || part.front() == '-') return path + part;
  return fs::path(path).replace_extension().string() + part;
}

void force_to_disk(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool done = file >= 0 && ::fsync(file) == 0;
  const int error = errno;
  if (file >= 0) ::close(file);
  if (!done) throw IoError("cannot write " + path + ": " + std::strerror(error));
}

}  // namespace

// No step after the folder exists may fail and leave it behind, so all names are made before: mkdtemp() replaces the
// six X, and what it wrote is copied over the beginning of each name, which allocates nothing.
StagedOutput::StagedOutput(const std::string& target, OutputFiles files) : files_(std::move(files)) {
  std::error_code error;
  // Through a symbolic link the file it points to is replaced, not the link.
  target_ = fs::is_symlink(target, error) ? fs::weakly_canonical(target).string() : target;
  const fs::path full = target_;
  const fs::path parent = full.has_parent_path() ? full.parent_path() : fs::path(".");
  std::string folder = (parent / fmt::format(".{}.writing-XXXXXX", full.filename().string())).string();
  path_ = (fs::path(folder) / full.filename()).string();
  auto unfinished = std::make_unique<UnfinishedOutput>();
  for (const auto& list : {files_.parts, files_.scratch}) {
    for (const std::string& part : list) unfinished->files.push_back(part_of(path_, part));
  }
  if (!::mkdtemp(folder.data())) throw IoError("cannot write into " + parent.string() + ": " + std::strerror(errno));
  folder.copy(path_.data(), folder.size());
  for (std::string& file : unfinished->files) folder.copy(file.data(), folder.size());
  unfinished->folder = std::move(folder);
  unfinished_ = unfinished.release();
  remember(unfinished_);
}

StagedOutput::~StagedOutput() {
  if (!discard(*unfinished_)) remove_with_strangers(unfinished_->folder);
  if (forget(unfinished_)) {
    delete unfinished_;
  } else {  // a signal handler may be at work with it: never freed
    unfinished_->next_abandoned = abandoned;
    while (!abandoned.compare_exchange_weak(unfinished_->next_abandoned, unfinished_)) {
    }
  }
}

// Between the first rename and the last nothing can fail for lack of memory: all names are made before.
void StagedOutput::commit() {
  struct Rename {
    fs::path from, to;
  };
  std::vector<Rename> renames;
  std::vector<fs::path> removals;
  std::error_code error;
  const bool replaces = fs::exists(target_, error);
  for (const std::string& part : files_.parts) {
    fs::path from = part_of(path_, part), to = part_of(target_, part);
    if (!fs::exists(from, error)) {
      removals.push_back(std::move(to));
      continue;
    }
    if (replaces) force_to_disk(from.string());
    renames.push_back({std::move(from), std::move(to)});
  }
  for (const std::string& part : files_.stale) removals.emplace_back(part_of(target_, part));
  for (const auto& [from, to] : renames) {
    fs::rename(from, to, error);
    if (error) throw IoError("cannot write " + to.string() + ": " + error.message());
  }
  for (const fs::path& file : removals) fs::remove(file, error);
}

void discard_unfinished() {
  for (auto& slot : unfinished_outputs) {
    const UnfinishedOutput* output = slot.exchange(nullptr);
    if (!output) continue;
    discard(*output);
  }
}

}  // namespace oblast::io
