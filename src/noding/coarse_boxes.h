// Boxes on a grid of 2^16 by 2^16 cells, on which many of them are compared at once.
//
// They are put in order along one axis, roughly, by counting: so there is nothing to foresee, and of each box only
// those that begin before its end are compared, sixteen at a time.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/call_memory.h"
#include "base/tuning.h"
#include "noding/monotone_runs.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace oblast::internal::noding {

class CoarseBoxes {
 public:
  /// The boxes of the runs. Memory: 12 bytes a run, kept for the next call.
  /// REQUIRES: runs.
  void assign(std::span<const Run> runs);

  /// Calls visit(i, j) for every two runs whose boxes meet, and for a few whose boxes come near each other. Cost: where
  /// boxes are short along the axis next to nothing for a pair that is not visited, else about one instruction.
  template <class Visit>
  void for_each_pair(const Visit& visit) const {
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const std::size_t past = past_[bucket_of(blocks_[i / block].x1[i % block])];
      // Of the first block those up to i itself are left out.
      std::uint32_t wanted = ~0U << (i % block + 1);
      for (std::size_t b = i / block; b * block < past; ++b, wanted = ~0U)
        for (std::uint32_t near = meeting(i, b) & wanted; near != 0; near &= near - 1)
          visit(order_[i], order_[b * block + static_cast<std::size_t>(std::countr_zero(near))]);
    }
  }

 private:
  static constexpr std::size_t block = 16;
  static constexpr int bucket_bits = tuning::box_bucket_bits;

  /// So many boxes, side by side. Boxes are in the order of the buckets of their x0; which axis is x is as it fits.
  struct Block {
    alignas(16) std::int16_t x0[block], y0[block], x1[block], y1[block];
  };

  static std::size_t bucket_of(std::int16_t x) { return static_cast<std::uint32_t>(x + 0x8000) >> (16 - bucket_bits); }

  /// Bit k: box i meets box k of a block.
  std::uint32_t meeting(std::size_t i, std::size_t b) const {
    const Block &own = blocks_[i / block], &others = blocks_[b];
    const std::size_t k = i % block;
#ifdef __SSE2__
    const __m128i x0 = _mm_set1_epi16(own.x0[k]), y0 = _mm_set1_epi16(own.y0[k]);
    const __m128i x1 = _mm_set1_epi16(own.x1[k]), y1 = _mm_set1_epi16(own.y1[k]);
    const auto apart = [&](std::size_t first) {
      const auto load = [first](const std::int16_t* values) {
        return _mm_load_si128(reinterpret_cast<const __m128i*>(values + first));
      };
      return _mm_or_si128(_mm_or_si128(_mm_cmpgt_epi16(load(others.x0), x1), _mm_cmpgt_epi16(load(others.y0), y1)),
                          _mm_or_si128(_mm_cmpgt_epi16(x0, load(others.x1)), _mm_cmpgt_epi16(y0, load(others.y1))));
    };
    return static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_packs_epi16(apart(0), apart(block / 2)))) ^ 0xffff;
#else
    std::uint32_t found = 0;
    for (std::size_t q = 0; q < block; ++q)
      found |= static_cast<std::uint32_t>(
                   static_cast<int>(others.x0[q] <= own.x1[k]) & static_cast<int>(others.y0[q] <= own.y1[k]) &
                   static_cast<int>(own.x0[k] <= others.x1[q]) & static_cast<int>(own.y0[k] <= others.y1[q]))
               << q;
    return found;
#endif
  }

  Array<Block> blocks_;
  Array<std::uint32_t> order_;                           ///< the run of each box
  std::array<std::uint32_t, 1U << bucket_bits> past_{};  ///< by bucket: past its last box
};

}  // namespace oblast::internal::noding
