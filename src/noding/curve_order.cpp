#include "noding/curve_order.h"

#include <algorithm>
#include <array>
#include <utility>

#include "memory/large_pages.h"

namespace oblast::noding {
namespace {

// The curve in its four orientations. Quadrants are numbered 2 x + y.
//
//   orientation 0   1--2      rank of each quadrant on the curve, and the orientation of the curve
//                   |  |      inside it: 1 is mirrored at the main diagonal, 2 at the other, 3 is
//                   0  3      turned by half a turn.
constexpr std::uint8_t rank_in[4][4] = {{0, 1, 3, 2}, {0, 3, 1, 2}, {2, 1, 3, 0}, {2, 3, 1, 0}};
constexpr std::uint8_t orientation_in[4][4] = {{1, 0, 2, 0}, {0, 3, 1, 1}, {2, 2, 0, 3}, {3, 1, 3, 2}};

/// Four levels at a time: 4 bits of x and of y to 8 bits of the key and the orientation inside.
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

/// Place on the curve of the cell (x, y) of a 2^16 x 2^16 grid.
std::uint32_t hilbert_key(std::uint32_t x, std::uint32_t y) {
  std::uint32_t key = 0, orientation = 0;
  for (int shift = 12; shift >= 0; shift -= 4) {
    const FourLevels four = four_levels[orientation * 256 + ((x >> shift) & 15) * 16 + ((y >> shift) & 15)];
    key = key << 8 | four.key;
    orientation = four.orientation;
  }
  return key;
}

/// Least significant digit first, 11 bits at a time.
void radix_sort(std::span<Keyed> items, std::vector<Keyed>& buffer) {
  constexpr int digits = 3, bits = 11, radix = 1 << bits;
  resize_in_large_pages(buffer, items.size());
  std::array<std::array<std::uint32_t, radix>, digits> starts{};
  for (const Keyed& k : items)
    for (int d = 0; d < digits; ++d) ++starts[d][(k.key >> (d * bits)) % radix];
  for (auto& digit : starts) {
    std::uint32_t sum = 0;
    for (std::uint32_t& s : digit) s = std::exchange(sum, sum + s);
  }
  std::span<Keyed> from = items, to = buffer;
  for (int d = 0; d < digits; ++d) {
    for (const Keyed& k : from) to[starts[d][(k.key >> (d * bits)) % radix]++] = k;
    std::swap(from, to);
  }
  std::copy(from.begin(), from.end(), items.begin());  // an odd number of passes ends in the buffer
}

class CurveSort {
 public:
  explicit CurveSort(std::span<const Point> points) : points_(points) {
    resize_in_large_pages(items_, points.size());
    for (std::uint32_t i = 0; i < items_.size(); ++i) items_[i].index = i;
  }

  std::vector<Keyed> run() {
    if (!items_.empty()) pending_.push_back({0, static_cast<std::uint32_t>(items_.size())});
    while (!pending_.empty()) {
      const auto [begin, end] = pending_.back();
      pending_.pop_back();
      const auto part = std::span(items_).subspan(begin, end - begin);
      if (!give_keys(part)) continue;
      if (part.size() < 2000)
        std::sort(part.begin(), part.end(),
                  [](const Keyed& p, const Keyed& q) { return p.key != q.key ? p.key < q.key : p.index < q.index; });
      else
        radix_sort(part, buffer_);
      queue_crowded_cells(begin, end);
    }
    return std::move(items_);
  }

 private:
  static constexpr std::uint32_t crowd = 16;  // so many points in one cell are sorted again inside it

  /// False when all points are the same.
  bool give_keys(std::span<Keyed> part) const {
    Point low = points_[part[0].index], high = low;
    for (const Keyed& k : part) {
      const Point& p = points_[k.index];
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double size = std::max(high.x - low.x, high.y - low.y);
    if (size == 0) return false;
    const double scale = 65535.0 / size;
    for (Keyed& k : part) {
      const Point& p = points_[k.index];
      k.key = hilbert_key(static_cast<std::uint32_t>((p.x - low.x) * scale),
                          static_cast<std::uint32_t>((p.y - low.y) * scale));
    }
    return true;
  }

  void queue_crowded_cells(std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t first = begin, last; first < end; first = last) {
      for (last = first + 1; last < end && items_[last].key == items_[first].key; ++last) continue;
      if (last - first >= crowd) pending_.push_back({first, last});
    }
  }

  struct Range {
    std::uint32_t begin;
    std::uint32_t end;
  };

  std::span<const Point> points_;
  std::vector<Keyed> items_;
  std::vector<Keyed> buffer_;
  std::vector<Range> pending_;
};

}  // namespace

std::vector<Keyed> curve_order(std::span<const Point> points) { return CurveSort(points).run(); }

}  // namespace oblast::noding
