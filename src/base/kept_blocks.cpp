#include "base/kept_blocks.h"

#include <oblast/workspace.h>

#include <new>

#include "base/call.h"
#include "base/memory_budget.h"
#include "base/tuning.h"

namespace oblast::internal {
namespace {

constexpr std::size_t shortest = tuning::shortest_kept_block;

}  // namespace

struct alignas(__STDCPP_DEFAULT_NEW_ALIGNMENT__) KeptBlocks::Header {
  KeptBlocks* owner;  ///< null: the system
  std::size_t bytes;  ///< including the header
};

KeptBlocks::KeptBlocks(std::size_t most_bytes) : most_bytes_(most_bytes) { free_.reserve(most_bytes / shortest + 1); }

std::size_t KeptBlocks::bytes() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

void KeptBlocks::clear() {
  const std::lock_guard lock(mutex_);
  while (!free_.empty()) drop_oldest();
}

void KeptBlocks::drop_oldest() {
  Header* const header = free_.front();
  free_.erase(free_.begin());
  bytes_ -= header->bytes;
  ::operator delete(header);
}

/// The shortest block that is long enough, or null.
KeptBlocks::Header* KeptBlocks::take(std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  auto best = free_.end();
  for (auto it = free_.begin(); it != free_.end(); ++it) {
    const std::size_t size = (*it)->bytes;
    if (size >= bytes && size / tuning::largest_kept_excess <= bytes && (best == free_.end() || size < (*best)->bytes))
      best = it;
  }
  if (best == free_.end()) return nullptr;
  Header* const header = *best;
  free_.erase(best);
  bytes_ -= header->bytes;
  return header;
}

void KeptBlocks::keep(Header* header) {
  const std::lock_guard lock(mutex_);
  free_.push_back(header);
  bytes_ += header->bytes;
  while (bytes_ > most_bytes_) drop_oldest();
}

void* take_uncounted_block(std::size_t bytes) {
  if (bytes < shortest) return ::operator new(bytes);
  const std::size_t with_header = bytes + sizeof(KeptBlocks::Header);
  const Call* const call = Call::current();
  KeptBlocks* const owner = call ? call->blocks : nullptr;
  KeptBlocks::Header* header = owner ? owner->take(with_header) : nullptr;
  if (!header) {
    header = new (::operator new(with_header)) KeptBlocks::Header{owner, with_header};
  }
  return header + 1;
}

void* take_block(std::size_t bytes) {
  MemoryBudget* const budget = MemoryBudget::current();
  if (!budget) return take_uncounted_block(bytes);
  Charge charge(bytes);
  void* const block = take_uncounted_block(bytes);
  charge.keep();  // until the block is given back
  return block;
}

void give_block_back(void* block, std::size_t bytes) {
  if (MemoryBudget* const budget = MemoryBudget::current()) budget->give_back(bytes);
  give_uncounted_block_back(block, bytes);
}

void give_uncounted_block_back(void* block, std::size_t bytes) {
  if (bytes < shortest) {
    ::operator delete(block);
    return;
  }
  KeptBlocks::Header* const header = static_cast<KeptBlocks::Header*>(block) - 1;
  if (header->owner)
    header->owner->keep(header);
  else
    ::operator delete(header);
}

KeptBlocks* kept_blocks(Workspace* workspace, std::size_t vertices) {
  KeptBlocks* const blocks = workspace ? workspace->blocks_.get() : nullptr;
  // The largest arrays alone take some thirty bytes per vertex.
  constexpr std::size_t bytes_a_vertex = 64;
  if (blocks && vertices > blocks->most_bytes() / bytes_a_vertex) {
    blocks->clear();
    return nullptr;
  }
  return blocks;
}

}  // namespace oblast::internal

namespace oblast {

Workspace::Workspace(std::size_t most_bytes) : blocks_(std::make_unique<internal::KeptBlocks>(most_bytes)) {}
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;
Workspace::~Workspace() = default;

std::size_t Workspace::kept_bytes() const { return blocks_ ? blocks_->bytes() : 0; }
void Workspace::clear() {
  if (blocks_) blocks_->clear();
}

}  // namespace oblast
