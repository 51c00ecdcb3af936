#include "noding/merge_identical_edges.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "memory/large_pages.h"
#include "noding/point_hash.h"
#include "parallel/for_ranges.h"

namespace oblast::noding {
namespace {

constexpr std::uint32_t none = 0xffffffff;

/// The same for both directions of an edge, from hash() of its ends.
std::uint32_t edge_hash(std::uint64_t from, std::uint64_t to) { return static_cast<std::uint32_t>((from + to) >> 32); }

/// How many places ahead of a walk what it will look up is asked for: the tables are larger than the nearest cache.
constexpr std::uint32_t ahead = 16;

/// A set of hashes, up to some chance likeness: a few bits each.
class HashBits {
 public:
  HashBits(std::size_t hashes, std::size_t bits_each) {
    resize_in_large_pages(words_, std::bit_ceil(hashes * bits_each / 64 + 1));
  }

  void prefetch(std::uint32_t hash) const { __builtin_prefetch(&words_[place(hash)], 1); }
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
  EdgeTable(const Array<Point>& points, std::size_t most_edges)
      : points_(points), slots_(std::bit_ceil(most_edges + most_edges / 2 + 2), none), mask_(slots_.size() - 1) {}

  void prefetch(std::uint32_t hash) const { __builtin_prefetch(&slots_[hash & mask_], 1); }
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
  const Array<Point>& points_;
  Array<std::uint32_t> slots_;
  std::uint64_t mask_;
};

/// Visits the edges a few at a time: prepare(edge) for each of them, then visit(edge).
template <class Prepare, class Visit>
void for_edges(const Strands& strands, const Prepare& prepare, const Visit& visit) {
  for (std::size_t s = 0; s < strands.size(); ++s) {
    const std::uint32_t last = strands.ends[s] - 1;
    for (std::uint32_t first = strands.begin(s); first < last; first += ahead) {
      const std::uint32_t past = std::min(first + ahead, last);
      for (std::uint32_t e = first; e < past; ++e) prepare(e);
      for (std::uint32_t e = first; e < past; ++e) visit(e);
    }
  }
}

/// By edge. What is between two strands gets a value too.
Array<std::uint32_t> hash_edges(const Array<Point>& points) {
  Array<std::uint32_t> hashes;
  resize_in_large_pages(hashes, points.size(), none);
  constexpr std::size_t edges_a_task = 1 << 15;
  if (points.empty()) return hashes;
  for_ranges(points.size() - 1, edges_a_task, [&](std::size_t begin, std::size_t end) {
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
Array<std::uint32_t> repeated_hashes(const Strands& strands, const Array<std::uint32_t>& hashes) {
  constexpr std::size_t bits_an_edge = 16, edges_a_core = 1 << 16;
  const auto cores = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  const std::size_t shares = std::clamp<std::size_t>(hashes.size() / edges_a_core, 1, std::min<std::size_t>(cores, 8));
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
          [&](std::uint32_t e) {
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
  constexpr std::size_t enough = 1 << 11, edges_a_range = 1 << 15;
  const Array<Point>& points = strands.points;
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
  std::sort(chosen.begin(), chosen.end());
  const auto different = std::unique(chosen.begin(), chosen.end()) - chosen.begin();
  return chosen.empty() ? 0 : 1 - static_cast<double>(different) / static_cast<double>(chosen.size());
}

/// Gives classes to edges of which is_candidate(hash) holds, and `none` to all others. There are up to `candidates`.
/// REQUIRES: class_of holds hashes.
template <class IsCandidate>
void classify(const Strands& strands, std::size_t candidates, const IsCandidate& is_candidate,
              IdenticalEdges& identical) {
  Array<std::uint32_t>& class_of = identical.class_of;
  EdgeTable table(strands.points, candidates);
  for_edges(
      strands,
      [&](std::uint32_t e) {
        if (is_candidate(class_of[e])) table.prefetch(class_of[e]);
      },
      [&](std::uint32_t e) {
        const std::uint32_t hash = std::exchange(class_of[e], none);
        if (!is_candidate(hash)) return;
        const std::uint32_t first = table.find_or_insert(e, hash);
        if (first == e) return;
        if (class_of[first] == none) {
          class_of[first] = static_cast<std::uint32_t>(identical.first.size());
          identical.first.push_back(first);
        }
        class_of[e] = class_of[first];
      });
}

/// Classes where few edges are repeated: most are told by a look at a few bits.
void classify_few(const Strands& strands, IdenticalEdges& identical) {
  const Array<std::uint32_t>& hashes = identical.class_of;
  const Array<std::uint32_t> repeated = repeated_hashes(strands, hashes);
  if (repeated.empty()) return;

  // By other bits of the hash than before, so that those which only seemed to be repeated drop out.
  constexpr std::size_t bits_a_hash = 64;
  HashBits shared(repeated.size(), bits_a_hash);
  const auto other_bits = [](std::uint32_t hash) { return std::rotl(hash, 16); };
  for (const std::uint32_t hash : repeated) shared.add(other_bits(hash));
  const auto is_candidate = [&](std::uint32_t hash) { return shared.has(other_bits(hash)); };
  std::size_t candidates = 0;
  for_edges(
      strands, [](std::uint32_t) {}, [&](std::uint32_t e) { candidates += is_candidate(hashes[e]); });
  classify(strands, candidates, is_candidate, identical);
}

}  // namespace

IdenticalEdges identical_edges(const Strands& strands) {
  constexpr std::size_t worth_sampling = 1 << 14;
  constexpr double many = 0.2;
  IdenticalEdges identical;
  const std::size_t edges = strands.points.size();
  const double part = edges < worth_sampling ? many / 2 : repeated_part(strands);
  if (part == 0) return {};
  identical.class_of = hash_edges(strands.points);
  if (part < many)
    classify_few(strands, identical);
  else
    classify(
        strands, edges, [](std::uint32_t) { return true; }, identical);
  if (identical.empty()) return {};
  // What is between two strands is no edge.
  for (const std::uint32_t end : strands.ends) identical.class_of[end - 1] = none;
  return identical;
}

Strands merge_identical_edges(Strands strands, const IdenticalEdges& identical) {
  if (identical.empty()) return strands;
  const auto& points = strands.points;
  const auto& class_of = identical.class_of;
  Array<Winding> sums(identical.first.size());  // by class, along it from its smaller end
  for (std::size_t s = 0; s < strands.size(); ++s) {
    for (std::uint32_t e = strands.begin(s); e + 1 < strands.ends[s]; ++e) {
      if (class_of[e] == none) continue;
      Winding& sum = sums[class_of[e]];
      sum = lexicographically_less(points[e], points[e + 1]) ? sum + strands.change[s] : sum - strands.change[s];
    }
  }
  for (Winding& sum : sums) sum = strands.parity.reduce(sum);

  Strands result;
  result.parity = strands.parity;
  result.points.reserve(points.size());
  for (std::size_t s = 0; s < strands.size(); ++s) {
    const std::uint32_t begin = strands.begin(s), end = strands.ends[s];
    std::uint32_t first = begin;
    for (std::uint32_t e = begin; e < end; ++e) {
      const bool last_vertex = e + 1 == end;
      if (!last_vertex && class_of[e] == none) continue;
      const bool whole = first == begin && last_vertex;
      if (e > first) {
        result.points.insert(result.points.end(), points.begin() + first, points.begin() + e + 1);
        result.close_strand(strands.change[s], strands.group[s], whole ? strands.simplicity[s] : Simplicity::known);
      }
      first = e + 1;
    }
  }
  for (std::size_t c = 0; c < sums.size(); ++c) {
    if (sums[c].is_zero()) continue;
    const Point &a = points[identical.first[c]], &b = points[identical.first[c] + 1];
    result.points.push_back(std::min(a, b, lexicographically_less));
    result.points.push_back(std::max(a, b, lexicographically_less));
    result.close_strand(sums[c], any_group);
  }
  return result;
}

}  // namespace oblast::noding
