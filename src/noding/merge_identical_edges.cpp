#include "noding/merge_identical_edges.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "base/fetch.h"
#include "base/index.h"
#include "base/large_pages.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "plane/point_hash.h"

namespace oblast::internal::noding {
namespace {

/// The same for both directions of an edge, from hash() of its ends.
std::uint32_t edge_hash(std::uint64_t from, std::uint64_t to) { return static_cast<std::uint32_t>((from + to) >> 32); }

/// How many places ahead of a walk what it will look up is asked for: the tables are larger than the nearest cache.
constexpr std::uint32_t ahead = 16;

/// A set of hashes, up to some chance likeness: a few bits each.
class HashBits {
 public:
  HashBits(std::size_t hashes, std::size_t bits_each) {
    resize_with_zeros(words_, std::bit_ceil(hashes * bits_each / 64 + 1));
  }

  void prefetch(std::uint32_t hash) const { fetch_to_write(&words_[place(hash)]); }
  /// Whether it was there before.
  bool add(std::uint32_t hash) {
    std::uint64_t& word = words_[place(hash)];
    const std::uint64_t bit = std::uint64_t{1} << (hash & 63);
    return (std::exchange(word, word | bit) & bit) != 0;
  }
  bool has(std::uint32_t hash) const { return (words_[place(hash)] >> (hash & 63) & 1) != 0; }

  /// Which of `shares` equal shares of the words a hash belongs to.
  std::size_t share_of(std::uint32_t hash, std::size_t shares) const { return place(hash) * shares / words_.size(); }

 private:
  std::size_t place(std::uint32_t hash) const { return (hash >> 6) & (words_.size() - 1); }

  Array<std::uint64_t> words_;
};

/// Finds to every edge the first one with the same ends: an open-addressing table of edges.
class EdgeTable {
 public:
  EdgeTable(const LargeArray<Point>& points, std::size_t most_edges)
      : points_(points), slots_(std::bit_ceil(most_edges + most_edges / 2 + 2), none), mask_(slots_.size() - 1) {}

  void prefetch(std::uint32_t hash) const { fetch_to_write(&slots_[hash & mask_]); }
  /// The first edge with the ends of this one; the edge itself when it is new.
  std::uint32_t find_or_insert(std::uint32_t edge, std::uint32_t hash) {
    const Point &a = points_[edge], &b = points_[edge + 1];
    for (std::uint64_t slot = hash;; ++slot) {
      std::uint32_t& entry = slots_[slot & mask_];
      if (entry == none) return entry = edge;
      const Point &c = points_[entry], &d = points_[entry + 1];
      if ((a == d && b == c) || (a == c && b == d)) return entry;
    }
  }

 private:
  const LargeArray<Point>& points_;
  Array<std::uint32_t> slots_;
  std::uint64_t mask_;
};

/// Visits the edges a few at a time: prepare(edge) for each of them, then visit(edge, its strand).
template <class Prepare, class Visit>
void for_edges(const Strands& strands, const Prepare& prepare, const Visit& visit) {
  Steps steps(strands.size() + strands.points.size() / ahead);
  for (std::size_t s = 0; s < strands.size(); ++s) {
    const std::uint32_t last = strands.ends[s] - 1;
    for (std::uint32_t first = strands.begin(s); first < last; first += ahead) {
      steps();
      const std::uint32_t past = std::min(first + ahead, last);
      for (std::uint32_t e = first; e < past; ++e) prepare(e);
      for (std::uint32_t e = first; e < past; ++e) visit(e, s);
    }
  }
}

/// By edge. What is between two strands gets a value too.
LargeArray<std::uint32_t> hash_edges(const LargeArray<Point>& points) {
  LargeArray<std::uint32_t> hashes;
  if (points.empty()) return hashes;
  resize_uninitialized(hashes, points.size() - 1);
  constexpr std::size_t edges_a_task = tuning::hashed_edges_a_task;
  for_ranges(hashes.size(), edges_a_task, [&](std::size_t begin, std::size_t end) {
    std::uint64_t from = hash(points[begin]);
    for (std::size_t e = begin; e < end; ++e) {
      const std::uint64_t to = hash(points[e + 1]);
      hashes[e] = edge_hash(from, to);
      from = to;
    }
  });
  return hashes;
}

/// The hashes that another edge had already, with some that only seem to. Each core looks after its share of the table.
Array<std::uint32_t> repeated_hashes(const Strands& strands, const LargeArray<std::uint32_t>& hashes) {
  constexpr std::size_t bits_an_edge = tuning::repeated_bits_an_edge, edges_a_core = tuning::repeated_edges_a_core;
  const std::size_t shares =
      std::clamp<std::size_t>(hashes.size() / edges_a_core, 1, std::min<std::size_t>(core_count(), 8));
  HashBits seen(hashes.size(), bits_an_edge);
  Array<Array<std::uint32_t>> repeated(shares);
  for_ranges(shares, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t share = begin; share < end; ++share) {
      const auto is_mine = [&](std::uint32_t e) { return shares == 1 || seen.share_of(hashes[e], shares) == share; };
      for_edges(
          strands,
          [&](std::uint32_t e) {
            if (is_mine(e)) seen.prefetch(hashes[e]);
          },
          [&](std::uint32_t e, std::size_t) {
            if (is_mine(e) && seen.add(hashes[e])) repeated[share].push_back(hashes[e]);
          });
    }
  });
  for (std::size_t share = 1; share < shares; ++share)
    repeated[0].insert(repeated[0].end(), repeated[share].begin(), repeated[share].end());
  return std::move(repeated[0]);
}

/// Which part of some of the edges, chosen by the bits of their ends, repeats another one.
double repeated_part(const Strands& strands) {
  constexpr std::size_t enough = tuning::sampled_edges, edges_a_range = tuning::sampled_edges_a_range;
  const LargeArray<Point>& points = strands.points;
  const std::size_t edges = points.size() - 1;
  const std::uint64_t one_in = edges / enough + 1;
  const auto is_chosen = [&](std::size_t e) {
    const std::uint64_t sum = std::bit_cast<std::uint64_t>(points[e].x) + std::bit_cast<std::uint64_t>(points[e + 1].x);
    return sum * 0x9e3779b97f4a7c15ULL <= ~std::uint64_t{0} / one_in;
  };
  Array<Array<std::uint64_t>> found(range_count(edges, edges_a_range));
  for_numbered_ranges(edges, edges_a_range, [&](std::size_t range, std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e)
      if (is_chosen(e)) found[range].push_back(hash(points[e]) + hash(points[e + 1]));
  });
  Array<std::uint64_t> chosen;
  for (const auto& hashes : found) chosen.insert(chosen.end(), hashes.begin(), hashes.end());
  // Copies are chosen together or not at all. A sample that is much smaller than expected may therefore miss all the
  // copies of a few edges, and says nothing.
  if (chosen.size() * 2 < edges / one_in) return tuning::many_repeated / 2;
  std::sort(chosen.begin(), chosen.end());
  const auto different = std::unique(chosen.begin(), chosen.end()) - chosen.begin();
  return 1 - static_cast<double>(different) / static_cast<double>(chosen.size());
}

/// Finds to every edge the first one with the same ends, among those of which is_candidate(hash) holds.
template <class IsCandidate>
class FirstFinder {
 public:
  /// REQUIRES: first_of holds hashes; at most `candidates` edges are candidates.
  FirstFinder(const Strands& strands, std::size_t candidates, const IsCandidate& is_candidate,
              LargeArray<std::uint32_t> hashes)
      : strands_(strands), is_candidate_(is_candidate), table_(strands.points, candidates) {
    identical_.first_of = std::move(hashes);
    resize_uninitialized(identical_.sum, identical_.first_of.size());
  }

  IdenticalEdges run() {
    auto& first_of = identical_.first_of;
    for (std::size_t s = 0; s + 1 < strands_.size(); ++s) first_of[strands_.ends[s] - 1] = no_edge;
    for_edges(
        strands_,
        [&](std::uint32_t e) {
          if (is_candidate_(first_of[e])) table_.prefetch(first_of[e]);
        },
        [&](std::uint32_t e, std::size_t s) {
          const std::uint32_t hash = std::exchange(first_of[e], none);
          if (is_candidate_(hash)) add(e, s, hash);
        });
    if (!any_) return {};
    for (std::size_t s = 0; s + 1 < strands_.size(); ++s) first_of[strands_.ends[s] - 1] = none;
    return std::move(identical_);
  }

 private:
  void add(std::uint32_t e, std::size_t s, std::uint32_t hash) {
    const auto& points = strands_.points;
    std::uint32_t first = following(e, points[e], points[e + 1]);
    if (first == none) {
      first = table_.find_or_insert(e, hash);
      if (first == e) {
        identical_.sum[e] = strands_.change[s];
        return;
      }
      beside_ = first;
      step_ = points[first] == points[e] ? 1 : -1U;
    }
    const bool forth = points[first] == points[e];
    identical_.sum[first] =
        forth ? identical_.sum[first] + strands_.change[s] : identical_.sum[first] - strands_.change[s];
    identical_.first_of[first] = identical_.first_of[e] = first;
    any_ = true;
  }

  /// Borders are long: after an edge that was there before, what follows is beside it, forth or back. The first edge
  /// with these ends if one of them is there.
  std::uint32_t following(std::uint32_t e, const Point& a, const Point& b) {
    if (beside_ == none) return none;
    const std::uint32_t next = beside_ + step_;
    const auto& points = strands_.points;
    const bool forth = step_ == 1;
    const bool same = next < e && points[next + !forth] == a && points[next + forth] == b;
    const std::uint32_t first = same ? identical_.first_of[next] : no_edge;
    beside_ = first == no_edge ? none : next;
    return first == none ? next : first == no_edge ? none : first;
  }

  static constexpr std::uint32_t no_edge = none - 1;  // what is between two strands

  const Strands& strands_;
  const IsCandidate& is_candidate_;
  EdgeTable table_;
  IdenticalEdges identical_;
  bool any_ = false;
  std::uint32_t beside_ = none;  ///< identical to the edge looked at last
  std::uint32_t step_ = 1;       ///< to what is beside the next one
};

/// Where few edges are repeated, most are told by a look at a few bits.
IdenticalEdges find_few(const Strands& strands, LargeArray<std::uint32_t> hashes) {
  const Array<std::uint32_t> repeated = repeated_hashes(strands, hashes);
  if (repeated.empty()) return {};

  // By other bits of the hash than before, so that those which only seemed to be repeated drop out.
  constexpr std::size_t bits_a_hash = tuning::repeated_bits_a_hash;
  HashBits shared(repeated.size(), bits_a_hash);
  const auto other_bits = [](std::uint32_t hash) { return std::rotl(hash, 16); };
  for (const std::uint32_t hash : repeated) shared.add(other_bits(hash));
  const auto is_candidate = [&](std::uint32_t hash) { return shared.has(other_bits(hash)); };
  const auto candidates = static_cast<std::size_t>(std::count_if(hashes.begin(), hashes.end(), is_candidate));
  return FirstFinder(strands, candidates, is_candidate, std::move(hashes)).run();
}

/// What is left of a range of strands: stretches without repeated edges, and the first of every identical ones.
class Remainder {
 public:
  Remainder(const Strands& strands, const IdenticalEdges& identical) : strands_(strands), identical_(identical) {}

  struct Size {
    std::size_t points = 0, strands = 0;
  };

  Size size(std::size_t first_strand, std::size_t past_strand) const {
    Size size;
    walk(first_strand, past_strand, [&](std::uint32_t first, std::uint32_t past, Winding, Group, Simplicity) {
      size.points += past - first;
      ++size.strands;
    });
    return size;
  }

  /// Writes it from `at` on. REQUIRES: there is room.
  void write(std::size_t first_strand, std::size_t past_strand, Size at, Strands& result) const {
    walk(first_strand, past_strand,
         [&](std::uint32_t first, std::uint32_t past, Winding change, Group group, Simplicity simplicity) {
           std::copy(strands_.points.begin() + first, strands_.points.begin() + past,
                     result.points.begin() + static_cast<std::ptrdiff_t>(at.points));
           at.points += past - first;
           result.ends[at.strands] = static_cast<std::uint32_t>(at.points);
           result.change[at.strands] = change;
           result.group[at.strands] = group;
           result.simplicity[at.strands] = simplicity;
           ++at.strands;
         });
  }

 private:
  /// Calls strand(first vertex, past the last one, change, group, simplicity).
  template <class Strand>
  void walk(std::size_t first_strand, std::size_t past_strand, const Strand& strand) const {
    for (std::size_t s = first_strand; s < past_strand; ++s) {
      const std::uint32_t begin = strands_.begin(s), end = strands_.ends[s];
      std::uint32_t first = begin;
      for (std::uint32_t e = begin; e < end; ++e) {
        const bool last_vertex = e + 1 == end;
        if (!last_vertex && identical_.first_of[e] == none) continue;
        const bool whole = first == begin && last_vertex;
        if (e > first)
          strand(first, e + 1, strands_.change[s], strands_.group[s],
                 whole ? strands_.simplicity[s] : Simplicity::known);
        first = e + 1;
        if (last_vertex || identical_.first_of[e] != e) continue;
        const Winding sum = strands_.parity.reduce(identical_.sum[e]);
        if (!sum.is_zero()) strand(e, e + 2, sum, any_group, Simplicity::known);
      }
    }
  }

  const Strands& strands_;
  const IdenticalEdges& identical_;
};

}  // namespace

IdenticalEdges identical_edges(const Strands& strands, Seek seek) {
  constexpr std::size_t worth_sampling = tuning::edges_worth_sampling;
  constexpr double many = tuning::many_repeated;
  if (seek == Seek::no || strands.points.empty()) return {};
  const std::size_t edges = strands.points.size();
  const double part = edges < worth_sampling ? many / 2 : repeated_part(strands);
  if (part == 0 && seek == Seek::if_frequent) return {};
  LargeArray<std::uint32_t> hashes = hash_edges(strands.points);
  if (part < many) return find_few(strands, std::move(hashes));
  const auto all = [](std::uint32_t) { return true; };
  return FirstFinder(strands, edges, all, std::move(hashes)).run();
}

Strands merge_identical_edges(Strands strands, const IdenticalEdges& identical) {
  if (identical.empty()) return strands;
  const Remainder remainder(strands, identical);
  const std::size_t strands_a_range = grain(strands.size(), strands.points.size());
  Array<Remainder::Size> ends(range_count(strands.size(), strands_a_range) + 1);
  for_numbered_ranges(strands.size(), strands_a_range, [&](std::size_t i, std::size_t first, std::size_t past) {
    ends[i + 1] = remainder.size(first, past);
  });
  for (std::size_t i = 1; i < ends.size(); ++i) {
    ends[i].points += ends[i - 1].points;
    ends[i].strands += ends[i - 1].strands;
  }
  // Where every second edge is repeated, each is a strand of its own.
  check_count(ends.back().points, "vertices of strands");
  Strands result;
  result.parity = strands.parity;
  result.resize(ends.back().points, ends.back().strands);
  for_numbered_ranges(strands.size(), strands_a_range, [&](std::size_t i, std::size_t first, std::size_t past) {
    remainder.write(first, past, ends[i], result);
  });
  return result;
}

}  // namespace oblast::internal::noding
