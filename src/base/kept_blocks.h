// Long blocks that calls leave for the next ones: the memory of a workspace.
//
// Each long block knows by its header whose it is, so any thread may free it. Those of a workspace go back to it, and
// are taken again by arrays that they fit; the rest is the system's.
#pragma once

#include <oblast/workspace.h>

#include <cstddef>
#include <mutex>
#include <vector>

namespace oblast::internal {

class KeptBlocks {
 public:
  explicit KeptBlocks(std::size_t most_bytes);
  KeptBlocks(const KeptBlocks&) = delete;
  KeptBlocks& operator=(const KeptBlocks&) = delete;
  ~KeptBlocks() { clear(); }

  std::size_t most_bytes() const { return most_bytes_; }
  std::size_t bytes() const;
  void clear();

 private:
  friend void* take_uncounted_block(std::size_t bytes);
  friend void give_block_back(void* block, std::size_t bytes);

  struct Header;

  Header* take(std::size_t bytes);
  void keep(Header* header);
  void drop_oldest();

  std::size_t most_bytes_;
  mutable std::mutex mutex_;
  std::size_t bytes_ = 0;
  std::vector<Header*> free_;  ///< the oldest first; has room for all that there can be
};

/// Memory of an array: of the workspace of the call that this thread works for, where there is one and the array is
/// long, or the system's; counted where the call has a limit (memory_budget.h). Throws std::bad_alloc and
/// Error(memory_limit).
void* take_block(std::size_t bytes);
/// REQUIRES: the same size.
void give_block_back(void* block, std::size_t bytes);

/// What a call on so many vertices has of a workspace: null where there is none, or where it is too small to help. Then
/// it is emptied, for the call will need the memory.
KeptBlocks* kept_blocks(Workspace* workspace, std::size_t vertices);

}  // namespace oblast::internal
