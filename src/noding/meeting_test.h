// The test of two edges: where they meet, and what follows from it.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <span>
#include <utility>

#include "base/call_memory.h"
#include "base/tuning.h"
#include "noding/edge_contact.h"
#include "noding/meetings.h"
#include "noding/pair_finder.h"
#include "noding/settling.h"
#include "noding/strands.h"
#include "plane/box.h"
#include "plane/point_hash.h"

namespace oblast::internal::noding {

/// Remembers pairs of edges that were looked at a short while ago: cells that lie beside each other bring up the same
/// ones. It forgets, so a pair may still be looked at again, which does no harm.
class RecentPairs {
 public:
  void prepare() {
    if (slots_.empty()) slots_.assign(slot_count, 0);
  }
  /// False when the pair is remembered.
  bool add(std::uint32_t i, std::uint32_t j) {
    if (slots_.empty()) return true;
    const std::uint64_t pair = static_cast<std::uint64_t>(std::min(i, j)) << 32 | std::max(i, j);
    return std::exchange(slots_[mix(pair) % slot_count], pair) != pair;
  }

 private:
  static constexpr std::size_t slot_count = tuning::recent_pairs;
  Array<std::uint64_t> slots_;  // no pair is 0: its edges would be the same
};

/// What one thread found.
struct Found {
  ContactList contacts;
  FirstFindings first;  ///< tangled strands repeatedly
  RecentPairs recent;
};

/// Tests pairs of edges and gathers what they ask for; one a thread.
class MeetingTest {
 public:
  MeetingTest(Strands& strands, Settling settling, Found& found, ContactCount& contact_count, Clearance* clearance,
              const FirstFindings* first);

  /// Every edge of one run against every edge of the other whose boxes meet.
  void test(std::span<const RunPair> pairs) {
    for (const RunPair& pair : pairs) test_runs(pair);
  }

 private:
  void test_runs(const RunPair& pair);
  void test_edges(std::uint32_t i, std::uint32_t j);
  void note_tangled(std::uint32_t i, std::uint32_t j);
  void look_at(std::uint32_t i, std::uint32_t j);
  bool test_clearly(std::uint32_t i, std::uint32_t j, const Point& a, const Point& b, const Point& c, const Point& d);
  void test_edges_with_common_end(std::uint32_t i, std::uint32_t j);
  void note_common_end(std::uint32_t i, std::uint32_t j, const Point& p, const Point& u, const Point& v);
  void cross(std::uint32_t i, std::uint32_t j);
  bool settle_at_an_end(std::uint32_t i, std::uint32_t j);
  void mark_fold(std::uint32_t p, const Point& p_tip, const Point& u, std::uint32_t q, const Point& q_tip,
                 const Point& v);
  void meet_at(std::uint32_t edge, const Point& x);
  void vertex_on_edge(std::uint32_t vertex, const Point& p, std::uint32_t edge);
  bool same_vertex(std::uint32_t p, std::uint32_t q) const;
  void flag_both(std::uint32_t i, std::uint32_t j);

  void mark(std::uint32_t vertex) {
    met_ = true;
    strands_.add_flag(vertex, node_flag);
  }
  void add_contact(std::uint32_t edge, float sine, const Point& at) {
    met_ = true;
    contacts_.push_back({edge, sine, at}, contact_count_);
  }

  Strands& strands_;
  const Point* points_;
  Settling settling_;
  ContactList& contacts_;
  ContactCount& contact_count_;
  RecentPairs& recent_;
  Clearance* clearance_;
  double distance_;
  FirstFindings& first_;
  bool seeks_identical_, seeks_tangled_;
  bool met_ = false;  ///< the two edges looked at meet
};

}  // namespace oblast::internal::noding
