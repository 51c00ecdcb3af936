// Locks tell what is in use; see leftovers.h.
#include "io/leftovers.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <iterator>
#include <map>
#include <mutex>
#include <random>
#include <vector>

namespace oblast::io {

namespace fs = std::filesystem;

namespace {

constexpr std::time_t seconds_until_locked = 2;

// Stages in a folder that were there when this program wrote into it for the first time. A folder of thousands of files
// is listed only once.
std::vector<fs::path> older_stages(const fs::path& parent) {
  static std::mutex mutex;
  static std::map<fs::path, std::vector<fs::path>> known;
  const std::lock_guard lock(mutex);
  const auto [entry, is_new] = known.try_emplace(parent);
  if (!is_new) return entry->second;
  std::error_code error;
  for (fs::directory_iterator it(parent, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (name.front() == '.' &&
        (name.find(".writing-") != std::string::npos || name.find(".stopped-") != std::string::npos))
      entry->second.push_back(it->path());
  }
  return entry->second;
}

}  // namespace

std::string stage_suffix() {
  constexpr char alphabet[] = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
  std::random_device device;
  std::string suffix;
  for (int i = 0; i < stage_suffix_length; ++i) suffix += alphabet[device() % (sizeof alphabet - 1)];
  return suffix;
}

int lock_stage(const std::string& folder) {
  const int lock = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock >= 0) ::flock(lock, LOCK_SH | LOCK_NB);  // where it fails, leftovers stay: no harm
  return lock;
}

// A living writer holds a lock on its stage; the kernel releases it however the program ends. So a stage of this target
// without a lock is what a killed program left. A stage that is a moment old may not be locked yet.
void remove_leftovers(const fs::path& parent, const std::string& file_name) {
  const std::string prefixes[] = {fmt::format(".{}.writing-", file_name), fmt::format(".{}.stopped-", file_name)};
  for (const fs::path& stage : older_stages(parent)) {
    const std::string name = stage.filename().string();
    const auto is_ours = [&](const std::string& prefix) {
      return name.size() == prefix.size() + stage_suffix_length && name.starts_with(prefix);
    };
    if (std::none_of(std::begin(prefixes), std::end(prefixes), is_ours)) continue;
    const int folder = ::open(stage.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (folder < 0) continue;
    struct stat status = {};
    std::error_code error;
    const bool settled = ::fstat(folder, &status) == 0 && ::time(nullptr) - status.st_mtime >= seconds_until_locked;
    if (settled && ::flock(folder, LOCK_EX | LOCK_NB) == 0) fs::remove_all(stage, error);
    ::close(folder);
  }
}

}  // namespace oblast::io
