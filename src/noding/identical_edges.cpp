#include "noding/identical_edges.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "base/tuning.h"
#include "noding/edge_hashes.h"
#include "noding/edge_table.h"

namespace oblast::internal::noding {
namespace {

/// Finds to every edge the first one with the same ends, among those of which is_candidate(hash) holds.
template <class IsCandidate>
class FirstFinder {
 public:
  /// REQUIRES: at most `candidates` edges are candidates.
  FirstFinder(const Strands& strands, const LargeArray<std::uint32_t>& hashes, std::size_t candidates,
              const IsCandidate& is_candidate)
      : strands_(strands), hashes_(hashes), is_candidate_(is_candidate), table_(strands.points, candidates) {
    fill_in_large_pages(identical_.first_of, hashes.size(), none);
    resize_uninitialized(identical_.sum, hashes.size());
  }

  IdenticalEdges run() {
    mark_gaps(gap);
    for_edges(
        strands_,
        [&](std::uint32_t e) {
          if (is_candidate_(hashes_[e])) table_.prefetch(hashes_[e]);
        },
        [&](std::uint32_t e, std::size_t s) {
          if (is_candidate_(hashes_[e])) add(e, s);
        });
    if (!any_) return {};
    mark_gaps(none);
    return std::move(identical_);
  }

 private:
  /// In first_of while the search goes on, where one strand ends and the next one begins: there is no edge.
  static constexpr std::uint32_t gap = most_indices + 1;
  static_assert(gap != none);

  void mark_gaps(std::uint32_t mark) {
    for (std::size_t s = 0; s + 1 < strands_.size(); ++s) identical_.first_of[strands_.ends[s] - 1] = mark;
  }

  void add(std::uint32_t e, std::size_t s) {
    const auto& points = strands_.points;
    std::uint32_t first = first_beside(e);
    if (first == none) {
      first = table_.find_or_insert(e, hashes_[e]);
      if (first == e) {
        identical_.sum[e] = strands_.change[s];
        return;
      }
      beside_ = first;
      forth_ = points[first] == points[e];
    }
    const bool forth = points[first] == points[e];
    identical_.sum[first] = strands_.rules.sum(identical_.sum[first], forth ? strands_.change[s] : -strands_.change[s]);
    identical_.first_of[first] = identical_.first_of[e] = first;
    any_ = true;
  }

  //   an earlier strand     --- beside --- next ---       forth: both strands run the same way
  //   this strand           ----  e-1 ----  e  ----       (back: next is the edge before `beside`)
  //
  /// Borders are long: after an edge that was there before, the next edge is often beside the next one of the earlier
  /// strand. The first edge with the ends of e if that is so, else none.
  std::uint32_t first_beside(std::uint32_t e) {
    if (beside_ == none) return none;
    const bool at_begin = !forth_ && beside_ == 0;
    const std::uint32_t next = forth_ ? beside_ + 1 : beside_ - 1;
    beside_ = !at_begin && next < e && is_identical(next, e) ? next : none;
    if (beside_ == none) return none;
    const std::uint32_t first = identical_.first_of[next];
    return first == none ? next : first;
  }

  /// Whether `next` is an edge, and e runs beside it in the direction that is followed.
  bool is_identical(std::uint32_t next, std::uint32_t e) const {
    const auto& points = strands_.points;
    return points[next + !forth_] == points[e] && points[next + forth_] == points[e + 1] &&
           identical_.first_of[next] != gap;
  }

  const Strands& strands_;
  const LargeArray<std::uint32_t>& hashes_;
  const IsCandidate& is_candidate_;
  EdgeTable table_;
  IdenticalEdges identical_;
  bool any_ = false;
  std::uint32_t beside_ = none;  ///< an earlier edge identical to the edge looked at last
  bool forth_ = true;            ///< `beside_` runs the same way as that edge
};

/// Where few edges are repeated, most are told by a look at a few bits.
IdenticalEdges find_few(const Strands& strands, const LargeArray<std::uint32_t>& hashes) {
  const Array<std::uint32_t> repeated = repeated_hashes(strands, hashes);
  if (repeated.empty()) return {};

  // By other bits of the hash than before, so that those which only seemed to be repeated drop out.
  constexpr std::size_t bits_a_hash = tuning::repeated_bits_a_hash;
  HashBits shared(repeated.size(), bits_a_hash);
  const auto other_bits = [](std::uint32_t hash) { return std::rotl(hash, 16); };
  for (const std::uint32_t hash : repeated) shared.add(other_bits(hash));
  const auto is_candidate = [&](std::uint32_t hash) { return shared.has(other_bits(hash)); };
  const auto candidates = static_cast<std::size_t>(std::count_if(hashes.begin(), hashes.end(), is_candidate));
  return FirstFinder(strands, hashes, candidates, is_candidate).run();
}

}  // namespace

IdenticalEdges identical_edges(const Strands& strands, Seek seek) {
  constexpr std::size_t worth_sampling = tuning::edges_worth_sampling;
  constexpr double many = tuning::many_repeated;
  if (seek == Seek::no || strands.points.empty()) return {};
  const std::size_t edges = strands.points.size();
  const double part = edges < worth_sampling ? many / 2 : repeated_part(strands);
  if (part == 0 && seek == Seek::if_frequent) return {};
  const LargeArray<std::uint32_t> hashes = hash_edges(strands.points);
  if (part < many) return find_few(strands, hashes);
  const auto all = [](std::uint32_t) { return true; };
  return FirstFinder(strands, hashes, edges, all).run();
}

}  // namespace oblast::internal::noding
