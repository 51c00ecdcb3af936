#include "noding/merge_identical_edges.h"

#include <algorithm>
#include <bit>

#include "noding/point_hash.h"

namespace oblast::noding {
namespace {

constexpr std::uint32_t none = 0xffffffff;

/// The edges that another edge may be identical to: those whose hash is shared by its last bits. Most are told apart by
/// one look into a table small enough for a cache.
class SharedHashes {
 public:
  explicit SharedHashes(const Strands& strands)
      : strands_(strands), table_(std::bit_ceil(strands.points.size() * bits_an_edge / 64 + 1)) {}

  std::vector<std::uint32_t> run() {
    std::uint64_t any = 0;
    for_each_edge([&](std::uint32_t, std::uint64_t hash) {
      Word& word = word_of(hash);
      const std::uint64_t repeated = word.seen & bit_of(hash);
      word.seen |= bit_of(hash);
      word.shared |= repeated;
      any |= repeated;
    });
    std::vector<std::uint32_t> edges;
    if (any == 0) return edges;
    for_each_edge([&](std::uint32_t e, std::uint64_t hash) {
      if (word_of(hash).shared & bit_of(hash)) edges.push_back(e);
    });
    return edges;
  }

 private:
  static constexpr std::size_t bits_an_edge = 16;
  struct Word {
    std::uint64_t seen = 0, shared = 0;  ///< by hash: some edge has it, more than one has
  };

  Word& word_of(std::uint64_t hash) { return table_[(hash >> 6) & (table_.size() - 1)]; }
  static std::uint64_t bit_of(std::uint64_t hash) { return std::uint64_t{1} << (hash & 63); }

  /// Visits every edge with a hash that is the same for both directions, a few edges after its word was asked for:
  /// the table is larger than the nearest cache.
  template <class Visit>
  void for_each_edge(const Visit& visit) {
    constexpr std::uint32_t most_ahead = 16;
    std::uint64_t hashes[most_ahead];
    for (std::size_t s = 0; s < strands_.size(); ++s) {
      const std::uint32_t last = strands_.ends[s] - 1;
      std::uint64_t from = hash(strands_.points[strands_.begin(s)]);
      for (std::uint32_t first = strands_.begin(s); first < last; first += most_ahead) {
        const std::uint32_t count = std::min(most_ahead, last - first);
        for (std::uint32_t i = 0; i < count; ++i) {
          const std::uint64_t to = hash(strands_.points[first + i + 1]);
          hashes[i] = mix(from + to);
          __builtin_prefetch(&word_of(hashes[i]), 1);
          from = to;
        }
        for (std::uint32_t i = 0; i < count; ++i) visit(first + i, hashes[i]);
      }
    }
  }

  const Strands& strands_;
  std::vector<Word> table_;
};

/// Links every edge to the first one with the same ends: an open-addressing table of edges.
class EdgeTable {
 public:
  EdgeTable(const std::vector<Point>& points, std::size_t edges)
      : points_(points), slots_(std::bit_ceil(edges * 2 + 2), none), mask_(slots_.size() - 1) {}

  /// The first edge with the ends of this one; the edge itself when it is new.
  std::uint32_t find_or_insert(std::uint32_t edge) {
    const Point &a = points_[edge], &b = points_[edge + 1];
    for (std::uint64_t slot = mix(hash(a) + hash(b)) >> 32;; ++slot) {
      std::uint32_t& entry = slots_[slot & mask_];
      if (entry == none) return entry = edge;
      const Point &c = points_[entry], &d = points_[entry + 1];
      if ((a == c && b == d) || (a == d && b == c)) return entry;
    }
  }

 private:
  const std::vector<Point>& points_;
  std::vector<std::uint32_t> slots_;
  std::uint64_t mask_;
};

struct Merged {
  std::uint32_t edge;
  Winding change;
};

}  // namespace

std::vector<std::uint32_t> identical_edges(const Strands& strands) {
  const std::vector<std::uint32_t> candidates = SharedHashes(strands).run();
  std::vector<std::uint32_t> same;
  if (candidates.empty()) return same;
  EdgeTable table(strands.points, candidates.size());
  for (const std::uint32_t e : candidates) {
    const std::uint32_t first = table.find_or_insert(e);
    if (first == e) continue;
    if (same.empty()) same.assign(strands.points.size(), none);
    same[first] = first;
    same[e] = first;
  }
  return same;
}

Strands merge_identical_edges(Strands strands, const std::vector<std::uint32_t>& same) {
  if (same.empty()) return strands;
  const auto& points = strands.points;
  std::vector<Winding> sums(points.size());  // by edge, for first edges that were repeated
  for (std::size_t s = 0; s < strands.size(); ++s) {
    for (std::uint32_t e = strands.begin(s); e + 1 < strands.ends[s]; ++e) {
      if (same[e] == none) continue;
      const bool same_direction = points[e] == points[same[e]];
      sums[same[e]] = sums[same[e]] + (same_direction ? strands.change[s] : -strands.change[s]);
    }
  }

  for (Winding& sum : sums) sum = strands.parity.reduce(sum);

  Strands result;
  result.parity = strands.parity;
  result.points.reserve(points.size());
  std::vector<Merged> merged;
  for (std::size_t s = 0; s < strands.size(); ++s) {
    const std::uint32_t begin = strands.begin(s), end = strands.ends[s];
    std::uint32_t first = begin;
    for (std::uint32_t e = begin; e < end; ++e) {
      const bool last_vertex = e + 1 == end;
      if (!last_vertex && same[e] == none) continue;
      if (!last_vertex && same[e] == e && !sums[e].is_zero()) merged.push_back({e, sums[e]});
      const bool whole = first == begin && last_vertex;
      if (e > first) {
        result.points.insert(result.points.end(), points.begin() + first, points.begin() + e + 1);
        result.close_strand(strands.change[s], strands.group[s], whole ? strands.simplicity[s] : Simplicity::known);
      }
      first = e + 1;
    }
  }
  for (const Merged& m : merged) {
    result.points.push_back(points[m.edge]);
    result.points.push_back(points[m.edge + 1]);
    result.close_strand(m.change, any_group);
  }
  return result;
}

}  // namespace oblast::noding
