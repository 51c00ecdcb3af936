#include "plane/curve_order.h"

#include <algorithm>
#include <array>

#include "base/counting_sort.h"
#include "base/large_pages.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "plane/box.h"

namespace oblast::internal {
namespace {

// The curve in its four orientations. Quadrants are numbered 2 x + y.
//
//   orientation 0   1--2      rank of each quadrant on the curve, and the orientation of the curve
//                   |  |      inside it: 1 is mirrored at the main diagonal, 2 at the other diagonal,
//                   0  3      3 is rotated by half a turn.
constexpr std::uint8_t rank_in[4][4] = {{0, 1, 3, 2}, {0, 3, 1, 2}, {2, 1, 3, 0}, {2, 3, 1, 0}};
constexpr std::uint8_t orientation_in[4][4] = {{1, 0, 2, 0}, {0, 3, 1, 1}, {2, 2, 0, 3}, {3, 1, 3, 2}};

/// Four levels at a time: converts 4 bits of x and of y to 8 bits of the key and the orientation inside.
struct FourLevels {
  std::uint8_t key;
  std::uint8_t orientation;
};

constexpr auto four_levels = [] {
  std::array<FourLevels, 4 * 256> table{};
  for (unsigned start = 0; start < 4; ++start) {
    for (unsigned xy = 0; xy < 256; ++xy) {
      unsigned key = 0, orientation = start;
      for (int bit = 3; bit >= 0; --bit) {
        const unsigned quadrant = ((xy >> (4 + bit)) & 1) * 2 + ((xy >> bit) & 1);
        key = key * 4 + rank_in[orientation][quadrant];
        orientation = orientation_in[orientation][quadrant];
      }
      table[start * 256 + xy] = {static_cast<std::uint8_t>(key), static_cast<std::uint8_t>(orientation)};
    }
  }
  return table;
}();

/// The position on the curve of the cell (x, y) of a 2^16 x 2^16 grid.
std::uint32_t hilbert_key(std::uint32_t x, std::uint32_t y) {
  std::uint32_t key = 0, orientation = 0;
  for (int shift = 12; shift >= 0; shift -= 4) {
    const FourLevels four = four_levels[orientation * 256 + ((x >> shift) & 15) * 16 + ((y >> shift) & 15)];
    key = key << 8 | four.key;
    orientation = four.orientation;
  }
  return key;
}

// A key has three digits.
constexpr int digit_bits = 11, radix = 1 << digit_bits;
using Counts = std::array<std::uint32_t, radix>;

std::uint32_t digit_of(const Keyed& k, int digit) { return (k.key >> (digit * digit_bits)) % radix; }

/// A counting sort by a digit: copies to `to`. `ends` becomes where each digit ends. Large arrays are sorted in a few
/// ranges side by side.
/// REQUIRES: items.
void sort_by_digit(std::span<const Keyed> from, int digit, Counts& ends, std::span<Keyed> to) {
  constexpr std::size_t items_a_range = tuning::keys_a_range;
  const std::size_t ranges = range_count(from.size(), items_a_range);
  Array<Counts> more(ranges - 1);  // of all ranges except the last
  const auto counts_of = [&](std::size_t range) -> Counts& { return range + 1 < ranges ? more[range] : ends; };
  for_numbered_ranges(from.size(), items_a_range, [&](std::size_t range, std::size_t begin, std::size_t end) {
    Counts& counts = counts_of(range);
    counts.fill(0);
    for (const Keyed& k : from.subspan(begin, end - begin)) ++counts[digit_of(k, digit)];
  });
  begins_of_ranges(ranges, radix, counts_of);
  for_numbered_ranges(from.size(), items_a_range, [&](std::size_t range, std::size_t begin, std::size_t end) {
    Counts& starts = counts_of(range);
    for (const Keyed& k : from.subspan(begin, end - begin)) to[starts[digit_of(k, digit)]++] = k;
  });
}

void sort_small(std::span<Keyed> items) {
  std::sort(items.begin(), items.end(),
            [](const Keyed& p, const Keyed& q) { return p.key != q.key ? p.key < q.key : p.index < q.index; });
}

/// Sorts by the first digit in one pass through memory. Then sorts each part, which fits a cache, by the other digits,
/// last digit first.
void radix_sort(std::span<Keyed> items, LargeArray<Keyed>& buffer) {
  if (buffer.size() < items.size()) {
    buffer = {};
    resize_uninitialized(buffer, items.size());
  }
  Counts ends;
  sort_by_digit(items, 2, ends, buffer);
  for_ranges(radix, tuning::digits_a_task, [&](std::size_t first, std::size_t past) {
    Counts starts;
    for (std::size_t part = first; part < past; ++part) {
      const std::uint32_t begin = part == 0 ? 0 : ends[part - 1], size = ends[part] - begin;
      const std::span<Keyed> sorted = items.subspan(begin, size), unsorted = std::span(buffer).subspan(begin, size);
      if (size <= tuning::few_keys_of_a_digit) {
        sort_small(unsorted);
        std::copy(unsorted.begin(), unsorted.end(), sorted.begin());
      } else {
        sort_by_digit(unsorted, 0, starts, sorted);
        std::copy(sorted.begin(), sorted.end(), unsorted.begin());
        sort_by_digit(unsorted, 1, starts, sorted);
      }
    }
  });
}

class CurveSort {
 public:
  explicit CurveSort(std::span<const Point> points) : points_(points) {
    resize_uninitialized(items_, points.size());
    for_ranges(items_.size(), points_a_task, [&](std::size_t first, std::size_t past) {
      for (std::size_t i = first; i < past; ++i) items_[i] = {0, static_cast<std::uint32_t>(i)};
    });
  }

  LargeArray<Keyed> run() {
    if (!items_.empty()) pending_.push_back({0, static_cast<std::uint32_t>(items_.size())});
    while (!pending_.empty()) {
      const auto [begin, end] = pending_.back();
      pending_.pop_back();
      const auto part = std::span(items_).subspan(begin, end - begin);
      if (!give_keys(part)) continue;
      if (part.size() <= tuning::few_keys)
        sort_small(part);
      else
        radix_sort(part, buffer_);
      queue_crowded_cells(begin, end);
    }
    return std::move(items_);
  }

 private:
  static constexpr std::uint32_t crowd =
      tuning::curve_crowd;  // this many points in one cell are sorted again inside it
  static constexpr std::size_t points_a_task = tuning::curve_points_a_task;

  /// False if all points are equal.
  bool give_keys(std::span<Keyed> part) const {
    const Box box = box_of(part);
    const Point low{box.x0, box.y0};
    const double size = std::max(box.x1 - box.x0, box.y1 - box.y0);
    if (size == 0) return false;
    const double scale = 65535.0 / size;
    for_ranges(part.size(), points_a_task, [&](std::size_t first, std::size_t past) {
      for (Keyed& k : part.subspan(first, past - first)) {
        const Point& p = points_[k.index];
        k.key = hilbert_key(static_cast<std::uint32_t>((p.x - low.x) * scale),
                            static_cast<std::uint32_t>((p.y - low.y) * scale));
      }
    });
    return true;
  }

  Box box_of(std::span<const Keyed> part) const {
    Array<Box> boxes(range_count(part.size(), points_a_task));
    for_numbered_ranges(part.size(), points_a_task, [&](std::size_t i, std::size_t begin, std::size_t end) {
      const Point& first = points_[part[begin].index];
      boxes[i] = Box::of(first, first);
      for (const Keyed& k : part.subspan(begin, end - begin)) boxes[i] = boxes[i].joined(points_[k.index]);
    });
    for (const Box& box : boxes) boxes[0] = boxes[0].joined(box);
    return boxes[0];
  }

  void queue_crowded_cells(std::uint32_t begin, std::uint32_t end) {
    // In a crowd, two items with the same key are half a crowd apart, and the first is at a multiple of this distance.
    constexpr std::uint32_t step = crowd / 2;
    for (std::uint32_t i = begin; i + step - 1 < end; i += step) {
      if (items_[i].key != items_[i + step - 1].key) continue;
      std::uint32_t first = i, last = i + step;
      while (first > begin && items_[first - 1].key == items_[i].key) --first;
      while (last < end && items_[last].key == items_[i].key) ++last;
      if (last - first >= crowd) pending_.push_back({first, last});
      while (i + step < last) i += step;
    }
  }

  struct Range {
    std::uint32_t begin;
    std::uint32_t end;
  };

  std::span<const Point> points_;
  LargeArray<Keyed> items_;
  LargeArray<Keyed> buffer_;
  Array<Range> pending_;
};

}  // namespace

LargeArray<Keyed> curve_order(std::span<const Point> points) { return CurveSort(points).run(); }

LargeArray<std::uint32_t> curve_order(std::span<const Box> boxes) {
  LargeArray<Point> middles;
  resize_uninitialized(middles, boxes.size());
  for_ranges(boxes.size(), tuning::boxes_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      middles[i] = {boxes[i].x0 / 2 + boxes[i].x1 / 2, boxes[i].y0 / 2 + boxes[i].y1 / 2};
  });
  const LargeArray<Keyed> keyed = curve_order(middles);
  LargeArray<std::uint32_t> order;
  resize_uninitialized(order, boxes.size());
  for_ranges(boxes.size(), tuning::boxes_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) order[i] = keyed[i].index;
  });
  return order;
}

}  // namespace oblast::internal
