// Writing beside the target, renaming, and cleaning up; see staged_output.h.
#include "io/staged_output.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
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
#include <random>

#include "io/layer.h"
#include "io/write.h"

namespace oblast::io {

namespace fs = std::filesystem;

// What discard_unfinished() removes. Made before writing begins, so that a signal handler finds the
// names ready: it may not allocate.
struct UnfinishedOutput {
  std::vector<std::string> files;  // names in the folder
  std::string folder;
  std::string gone;  // what a signal handler calls the folder before it empties it
  UnfinishedOutput* next_abandoned = nullptr;
};

namespace {

// Outputs under way, a few at a time. One that finds no free slot is merely not discarded on interruption.
std::array<std::atomic<UnfinishedOutput*>, 64> unfinished_outputs;

std::atomic<UnfinishedOutput*> abandoned = nullptr;
std::atomic<int> commits = 0;  // under way
static_assert(std::atomic<int>::is_always_lock_free);

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
bool discard(const UnfinishedOutput& output, const std::string& folder) {
  const int opened = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened >= 0) {
    for (const std::string& file : output.files) ::unlinkat(opened, file.c_str(), 0);
    ::close(opened);
  }
  return ::rmdir(folder.c_str()) == 0 || errno == ENOENT;
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

struct Commit {
  Commit() { ++commits; }
  Commit(const Commit&) = delete;
  Commit& operator=(const Commit&) = delete;
  ~Commit() { --commits; }
};

void force_to_disk(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool done = file >= 0 && ::fsync(file) == 0;
  const int error = errno;
  if (file >= 0) ::close(file);
  if (!done) throw IoError("cannot write " + path + ": " + std::strerror(error));
}

}  // namespace

namespace {

// Six characters of this alphabet.
std::string random_suffix() {
  constexpr char alphabet[] = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
  std::random_device device;
  std::string suffix;
  for (int i = 0; i < 6; ++i) suffix += alphabet[device() % (sizeof alphabet - 1)];
  return suffix;
}

}  // namespace

// No step after the folder exists may fail and leave it behind, and a signal may come at once: so all names are made
// and remembered before.
StagedOutput::StagedOutput(const std::string& target, OutputFiles files) : files_(std::move(files)) {
  std::error_code error;
  // Through a symbolic link the file it points to is replaced, not the link.
  target_ = fs::is_symlink(target, error) ? fs::weakly_canonical(target).string() : target;
  const fs::path full = target_;
  const fs::path parent = full.has_parent_path() ? full.parent_path() : fs::path(".");
  for (int attempts = 100;; --attempts) {
    const std::string suffix = random_suffix();
    auto unfinished = std::make_unique<UnfinishedOutput>();
    unfinished->folder = (parent / fmt::format(".{}.writing-{}", full.filename().string(), suffix)).string();
    unfinished->gone = (parent / fmt::format(".{}.stopped-{}", full.filename().string(), suffix)).string();
    path_ = (fs::path(unfinished->folder) / full.filename()).string();
    for (const auto& list : {files_.parts, files_.scratch}) {
      for (const std::string& part : list)
        unfinished->files.push_back(fs::path(part_of(path_, part)).filename().string());
    }
    remember(unfinished.get());
    if (::mkdir(unfinished->folder.c_str(), 0700) == 0) {
      unfinished_ = unfinished.release();
      return;
    }
    const int failure = errno;
    if (!forget(unfinished.get())) (void)unfinished.release();  // a signal handler is at work with it
    if (failure != EEXIST || attempts == 0)
      throw IoError("cannot write into " + parent.string() + ": " + std::strerror(failure));
  }
}

StagedOutput::~StagedOutput() {
  if (!discard(*unfinished_, unfinished_->folder)) remove_with_strangers(unfinished_->folder);
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
  // A signal that comes from here on is too late: what is there now shall not be half old and half new.
  const Commit commit;
  for (const auto& [from, to] : renames) {
    fs::rename(from, to, error);
    if (error) throw IoError("cannot write " + to.string() + ": " + error.message());
  }
  for (const fs::path& file : removals) fs::remove(file, error);
}

bool commit_under_way() { return commits > 0; }

void discard_unfinished() {
  for (auto& slot : unfinished_outputs) {
    const UnfinishedOutput* output = slot.exchange(nullptr);
    if (!output) continue;
    // Other threads may go on writing: under this name they make no more files.
    if (::rename(output->folder.c_str(), output->gone.c_str()) == 0) discard(*output, output->gone);
  }
}

}  // namespace oblast::io
