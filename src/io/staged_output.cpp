// Writes beside the target, renames, and cleans up; see staged_output.h.
#include "io/staged_output.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>

#include "io/layer.h"
#include "io/leftovers.h"
#include "io/write.h"

namespace oblast::io {

namespace fs = std::filesystem;

// The names of the files that discard_unfinished() removes. They are made before writing begins, because a signal
// handler must not allocate memory.
struct UnfinishedOutput {
  std::vector<std::string> files;  // names in the folder
  std::string folder;
  std::string gone;  // a signal handler renames the folder to this before it empties it
  UnfinishedOutput* next_abandoned = nullptr;
};

namespace {

// The outputs that are being written. There are a few slots; an output without a slot is not removed at a signal.
std::array<std::atomic<UnfinishedOutput*>, 64> unfinished_outputs;

std::atomic<UnfinishedOutput*> abandoned = nullptr;

// Whether the outputs may still be discarded. One atomic, so that a signal on one thread and a commit on another
// exclude each other: the first to change it wins.
constexpr std::uint32_t stopped = 1;     // by stop_outputs()
constexpr std::uint32_t committed = 2;   // a commit has begun, and expect_more_output() was not called since
constexpr std::uint32_t one_commit = 4;  // times the number of commits under way
std::atomic<std::uint32_t> commits = 0;
static_assert(std::atomic<std::uint32_t>::is_always_lock_free);

void remember(UnfinishedOutput* output) {
  for (auto& slot : unfinished_outputs) {
    UnfinishedOutput* none = nullptr;
    if (slot.compare_exchange_strong(none, output)) return;
  }
}

// False if discard_unfinished() has taken it.
bool forget(UnfinishedOutput* output) {
  for (auto& slot : unfinished_outputs) {
    UnfinishedOutput* expected = output;
    if (slot.compare_exchange_strong(expected, nullptr)) return true;
  }
  return false;
}

// Allocates no memory, so a signal handler and a destructor may call it. False if the folder has other files, too.
bool discard(const UnfinishedOutput& output, const std::string& folder) {
  const int opened = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened >= 0) {
    for (const std::string& file : output.files) ::unlinkat(opened, file.c_str(), 0);
    ::close(opened);
  }
  return ::rmdir(folder.c_str()) == 0 || errno == ENOENT;
}

// Removes files that a driver made under names that this code does not know.
void remove_with_strangers(const std::string& folder) {
  try {
    std::error_code error;
    fs::remove_all(folder, error);
  } catch (const std::bad_alloc&) {  // a destructor cannot report it
  }
}

std::string part_of(const std::string& path, const std::string& part) {
  if (part.empty() || part.front() == '-') return path + part;
  return fs::path(path).replace_extension().string() + part;
}

struct Commit {
  Commit() {
    std::uint32_t before = commits;
    while (!commits.compare_exchange_weak(before, (before + one_commit) | committed)) {
    }
    while (before & stopped) ::pause();  // another thread discards the outputs and ends the program
  }
  Commit(const Commit&) = delete;
  Commit& operator=(const Commit&) = delete;
  ~Commit() { commits -= one_commit; }
};

void force_to_disk(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool done = file >= 0 && ::fsync(file) == 0;
  const int error = errno;
  if (file >= 0) ::close(file);
  if (!done) throw IoError("cannot write " + path + ": " + std::strerror(error));
}

}  // namespace

// After the folder exists, no step may fail and leave it behind, and a signal may come at any time. So all names are
// made and stored before.
StagedOutput::StagedOutput(const std::string& target, OutputFiles files) : files_(std::move(files)) {
  std::error_code error;
  // If the target is a symbolic link, the file that it points to is replaced, not the link.
  target_ = fs::is_symlink(target, error) ? fs::weakly_canonical(target).string() : target;
  const fs::path full = target_;
  const fs::path parent = full.has_parent_path() ? full.parent_path() : fs::path(".");
  remove_leftovers(parent, full.filename().string());
  for (int attempts = 100;; --attempts) {
    const std::string suffix = stage_suffix();
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
      lock_ = lock_stage(unfinished_->folder);
      return;
    }
    const int failure = errno;
    if (!forget(unfinished.get())) (void)unfinished.release();  // a signal handler is using it
    if (failure != EEXIST || attempts == 0)
      throw IoError("cannot write into " + parent.string() + ": " + std::strerror(failure));
  }
}

StagedOutput::~StagedOutput() {
  if (lock_ >= 0) ::close(lock_);
  if (!discard(*unfinished_, unfinished_->folder)) remove_with_strangers(unfinished_->folder);
  if (forget(unfinished_)) {
    delete unfinished_;
  } else {  // a signal handler may be using it, so it is never freed
    unfinished_->next_abandoned = abandoned;
    while (!abandoned.compare_exchange_weak(unfinished_->next_abandoned, unfinished_)) {
    }
  }
}

// All names are made before the first rename. So lack of memory cannot stop the renames halfway.
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
  // From here on a signal does not end the program: it would leave some old and some new files.
  const Commit commit;
  for (const auto& [from, to] : renames) {
    fs::rename(from, to, error);
    if (error) throw IoError("cannot write " + to.string() + ": " + error.message());
  }
  for (const fs::path& file : removals) fs::remove(file, error);
}

void expect_more_output() { commits &= ~committed; }

bool stop_outputs() {
  std::uint32_t before = commits;
  do {
    if (before >= committed) return false;
  } while (!commits.compare_exchange_weak(before, before | stopped));
  return true;
}

void discard_unfinished() {
  for (auto& slot : unfinished_outputs) {
    const UnfinishedOutput* output = slot.exchange(nullptr);
    if (!output) continue;
    // Other threads may continue to write. After the rename they cannot make new files in the folder.
    if (::rename(output->folder.c_str(), output->gone.c_str()) == 0) discard(*output, output->gone);
  }
}

}  // namespace oblast::io
