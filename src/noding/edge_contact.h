// A contact: a place where a round of noding finds that an edge meets another one.
//
//              d                               u
//              |                             /
//     a ------ x ------ b                  p
//              |                             \.
//              c                               v
//
//     A cut: the edges cross, so          A common end: p u and p v both end in p. Nothing is to be cut,
//     a b is to be cut at x, and          but the angle between them decides whether their pieces keep
//     c d too.                            clear of each other (clearance.h).
//
// A round with a clearance gathers both kinds for each edge, sorts them along it (arrange_cuts.h), and asks the
// clearance about contacts that follow one another. Only the cuts leave the round.
#pragma once

#include <oblast/point.h>

#include <atomic>
#include <cstdint>
#include <span>

#include "base/call_memory.h"
#include "base/index.h"
#include "base/tuning.h"

namespace oblast::internal::noding {

struct EdgeContact {
  std::uint32_t edge;
  float sine;  ///< at most that of the angle to the edge met there; 0 where that is not clear
  Point at;    ///< in the edge's box; one of its ends (a common end), or else a cut

  /// Of the edge from a to b.
  bool is_common_end(const Point& a, const Point& b) const { return at == a || at == b; }
};

/// A contact inside its edge: the edge is to be cut there.
using EdgeCut = EdgeContact;

/// Contacts of all threads, counted by blocks, so that too many are noticed before they fill the memory.
class ContactCount {
 public:
  void add(std::size_t contacts) {
    check_count(count_.fetch_add(contacts, std::memory_order_relaxed) + contacts, "cuts");
  }

 private:
  std::atomic<std::size_t> count_ = 0;
};

/// Contacts as they are found. In blocks, which are not copied as they become many.
class ContactList {
 public:
  void push_back(const EdgeContact& contact, ContactCount& all) {
    if (blocks_.empty() || blocks_.back().size() == block_size) {
      if (!blocks_.empty()) all.add(block_size);
      blocks_.emplace_back();
      blocks_.back().reserve(blocks_.size() > 1 ? block_size : first_reserve);
    }
    blocks_.back().push_back(contact);
  }
  std::span<const Array<EdgeContact>> blocks() const { return blocks_; }

 private:
  static constexpr std::size_t block_size = tuning::cuts_a_block, first_reserve = tuning::first_cuts;
  Array<Array<EdgeContact>> blocks_;
};

}  // namespace oblast::internal::noding
