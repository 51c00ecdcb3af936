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

StagedOutput::StagedOutput(const std::string& target, OutputFiles files) : files_(std::move(files)) {
  std::error_code error;
  // Through a symbolic link the file it points to is replaced, not the link.
  target_ = fs::is_symlink(target, error) ? fs::weakly_canonical(target).string() : target;
  const fs::path full = target_;
  const fs::path parent = full.has_parent_path() ? full.parent_path() : fs::path(".");
  std::string pattern = (parent / fmt::format(".{}.writing-XXXXXX", full.filename().string())).string();
  if (!::mkdtemp(pattern.data())) throw IoError("cannot write into " + parent.string() + ": " + std::strerror(errno));
  folder_ = pattern;
  path_ = (fs::path(folder_) / full.filename()).string();

  unfinished_ = new UnfinishedOutput{{}, folder_};
  for (const auto& list : {files_.parts, files_.scratch}) {
    for (const std::string& part : list) unfinished_->files.push_back(part_of(path_, part));
  }
  remember(unfinished_);
}

StagedOutput::~StagedOutput() {
  std::error_code error;
  fs::remove_all(folder_, error);
  if (forget(unfinished_)) {
    delete unfinished_;
  } else {  // a signal handler may be at work with it: never freed
    unfinished_->next_abandoned = abandoned;
    while (!abandoned.compare_exchange_weak(unfinished_->next_abandoned, unfinished_)) {
    }
  }
}

void StagedOutput::commit() {
  std::error_code error;
  const bool replaces = fs::exists(target_, error);
  std::vector<std::string> missing;
  for (const std::string& part : files_.parts) {
    const std::string file = part_of(path_, part);
    if (!fs::exists(file, error)) {
      missing.push_back(part);
    } else if (replaces) {
      force_to_disk(file);
    }
  }
  for (const std::string& part : files_.parts) {
    if (std::find(missing.begin(), missing.end(), part) != missing.end()) continue;
    const std::string to = part_of(target_, part);
    fs::rename(part_of(path_, part), to, error);
    if (error) throw IoError("cannot write " + to + ": " + error.message());
  }
  for (const auto& list : {missing, files_.stale}) {
    for (const std::string& part : list) fs::remove(part_of(target_, part), error);
  }
}

void discard_unfinished() {
  for (auto& slot : unfinished_outputs) {
    const UnfinishedOutput* output = slot.exchange(nullptr);
    if (!output) continue;
    for (const std::string& file : output->files) ::unlink(file.c_str());
    ::rmdir(output->folder.c_str());
  }
}

}  // namespace oblast::io
