#include "noding/merge_identical_edges.h"

#include <algorithm>
#include <bit>

#include "noding/point_hash.h"

namespace oblast::noding {
namespace {

constexpr std::uint32_t none = 0xffffffff;

/// The same for both directions of an edge, from hash() of its ends.
std::uint32_t edge_hash(std::uint64_t from, std::uint64_t to) { return static_cast<std::uint32_t>((from + to) >> 32); }

/// How many places ahead of a walk what it will look up is asked for: the tables are larger than the nearest cache.
constexpr std::uint32_t ahead = 16;

/// Which hashes more than one edge has, up to some chance likeness: a table of few bits an edge.
class SharedHashes {
 public:
  explicit SharedHashes(std::size_t edges) : words_(std::bit_ceil(edges * bits_an_edge / 64 + 1)) {}

  void prefetch(std::uint32_t hash) const { __builtin_prefetch(&words_[place(hash)], 1); }
  /// Whether it was added before.
  bool add(std::uint32_t hash) {
    Word& word = words_[place(hash)];
    const std::uint64_t repeated = word.seen & bit(hash);
    word.seen |= bit(hash);
    word.shared |= repeated;
    return repeated != 0;
  }
  bool shares(std::uint32_t hash) const { return (words_[place(hash)].shared & bit(hash)) != 0; }

 private:
  static constexpr std::size_t bits_an_edge = 16;
  struct Word {
    std::uint64_t seen = 0, shared = 0;  ///< by hash: some edge has it, more than one has
  };

  std::size_t place(std::uint32_t hash) const { return (hash >> 6) & (words_.size() - 1); }
  static std::uint64_t bit(std::uint32_t hash) { return std::uint64_t{1} << (hash & 63); }

  std::vector<Word> words_;
};

/// Finds to every edge the first one with the same ends: an open-addressing table of edges.
class EdgeTable {
 public:
  EdgeTable(const std::vector<Point>& points, std::size_t most_edges)
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
  const std::vector<Point>& points_;
  std::vector<std::uint32_t> slots_;
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

}  // namespace

IdenticalEdges identical_edges(const Strands& strands) {
  const auto& points = strands.points;
  IdenticalEdges identical;
  // Hashes first, classes later: of each edge before it can be found by another one.
  std::vector<std::uint32_t>& class_of = identical.class_of;
  class_of.resize(points.size(), none);
  SharedHashes shared(points.size());
  std::size_t repeated = 0;
  std::uint64_t from = 0;
  std::uint32_t vertex = none;  // the one that `from` is the hash of
  for_edges(
      strands,
      [&](std::uint32_t e) {
        if (vertex != e) from = hash(points[e]);
        const std::uint64_t to = hash(points[e + 1]);
        class_of[e] = edge_hash(from, to);
        from = to;
        vertex = e + 1;
        shared.prefetch(class_of[e]);
      },
      [&](std::uint32_t e) { repeated += shared.add(class_of[e]); });
  if (repeated == 0) return {};

  // Of edges that share a hash with another one no more than half come first.
  EdgeTable table(points, 2 * repeated);
  for_edges(
      strands,
      [&](std::uint32_t e) {
        if (!shared.shares(class_of[e])) return;
        table.prefetch(class_of[e]);
      },
      [&](std::uint32_t e) {
        const std::uint32_t hash = std::exchange(class_of[e], none);
        if (!shared.shares(hash)) return;
        const std::uint32_t first = table.find_or_insert(e, hash);
        if (first == e) return;
        if (class_of[first] == none) {
          class_of[first] = static_cast<std::uint32_t>(identical.first.size());
          identical.first.push_back(first);
        }
        class_of[e] = class_of[first];
      });
  return identical;
}

Strands merge_identical_edges(Strands strands, const IdenticalEdges& identical) {
  if (identical.empty()) return strands;
  const auto& points = strands.points;
  const auto& class_of = identical.class_of;
  std::vector<Winding> sums(identical.first.size());  // by class, along it from its smaller end
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
