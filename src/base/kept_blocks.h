// The memory of a workspace: long blocks that calls keep for later calls.
//
// The header of a long block names its owner, so any thread may free it. A block of a workspace goes back to the
// workspace, and is reused for arrays that fit. Other blocks go back to the system.
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
  friend void give_uncounted_block_back(void* block, std::size_t bytes);

  struct Header;

  Header* take(std::size_t bytes);
  void keep(Header* header);
  void drop_oldest();

  std::size_t most_bytes_;
  mutable std::mutex mutex_;
  std::size_t bytes_ = 0;
  std::vector<Header*> free_;  ///< the oldest first; has capacity for the largest possible number
};

/// The same as the two functions below, for memory that no limit counts.
void* take_uncounted_block(std::size_t bytes);
void give_uncounted_block_back(void* block, std::size_t bytes);

/// Memory for an array. If the array is long and the call that this thread works for has a workspace, from the
/// workspace; otherwise from the system. Counted if the call has a limit (memory_budget.h). Throws std::bad_alloc and
/// Error(memory_limit).
void* take_block(std::size_t bytes);
/// REQUIRES: `bytes` is the size that was given to take_block.
void give_block_back(void* block, std::size_t bytes);

/// The blocks of a workspace for a call on so many vertices. Null if there is no workspace, or if it is too small to
/// help; then it is emptied, because the call will need the memory.
KeptBlocks* kept_blocks(Workspace* workspace, std::size_t vertices);

}  // namespace oblast::internal
