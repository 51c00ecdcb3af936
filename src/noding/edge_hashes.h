// Hashes of edges, and what they tell at a small cost: which edges may be repeated.
#pragma once

#include <oblast/point.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/call.h"
#include "base/fetch.h"
#include "base/large_pages.h"
#include "noding/strands.h"

namespace oblast::internal::noding {

/// How many places ahead of a walk what it will look up is asked for: the tables are larger than the nearest cache.
inline constexpr std::uint32_t edges_ahead = 16;

/// Visits the edges a few at a time: prepare(edge) for each of them, then visit(edge, its strand).
template <class Prepare, class Visit>
void for_edges(const Strands& strands, const Prepare& prepare, const Visit& visit) {
  Steps steps(strands.size() + strands.points.size() / edges_ahead);
  for (std::size_t s = 0; s < strands.size(); ++s) {
    const std::uint32_t last = strands.ends[s] - 1;
    for (std::uint32_t first = strands.begin(s); first < last; first += edges_ahead) {
      steps();
      const std::uint32_t past = std::min(first + edges_ahead, last);
      for (std::uint32_t e = first; e < past; ++e) prepare(e);
      for (std::uint32_t e = first; e < past; ++e) visit(e, s);
    }
  }
}

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

/// The same for both directions of an edge, from hash() of its ends.
inline std::uint32_t edge_hash(std::uint64_t from, std::uint64_t to) {
  return static_cast<std::uint32_t>((from + to) >> 32);
}

/// By edge, the same for both directions. The place between two strands gets a value too.
LargeArray<std::uint32_t> hash_edges(const LargeArray<Point>& points);

/// The hashes that another edge had already, with some that only seem to.
Array<std::uint32_t> repeated_hashes(const Strands& strands, const LargeArray<std::uint32_t>& hashes);

/// Which part of some of the edges, chosen by the bits of their ends, repeats another one.
double repeated_part(const Strands& strands);

}  // namespace oblast::internal::noding
