// Makes a failing case small enough to read.
#include "generators/shrink.h"

#include <vector>

#include "generators/soup.h"

namespace oblast::generators {
namespace {

// Both operands as nested lists, from which elements are easily dropped.
using Polygon = std::vector<Ring>;
struct Nested {
  std::vector<Polygon> operands[2];
};

Nested to_nested(const Operands& flat) {
  Nested nested;
  for (int o = 0; o < 2; ++o) {
    const RegionView view = o == 0 ? flat.a : flat.b;
    for (std::size_t p = 0; p < view.polygon_count(); ++p) {
      Polygon polygon;
      for (std::size_t c = view.polygon_begin(p); c < view.polygon_end(p); ++c) {
        polygon.emplace_back(view.contour(c).begin(), view.contour(c).end());
      }
      nested.operands[o].push_back(std::move(polygon));
    }
  }
  return nested;
}

Operands to_flat(const Nested& nested) {
  Operands flat;
  for (int o = 0; o < 2; ++o) {
    for (const Polygon& polygon : nested.operands[o]) {
      for (std::size_t c = 0; c < polygon.size(); ++c) {
        RegionSet& soup = o == 0 ? flat.a : flat.b;
        c == 0 ? add_polygon(soup, polygon[c]) : add_hole(soup, polygon[c]);
      }
    }
  }
  return flat;
}

class Shrinker {
 public:
  Shrinker(Nested nested, const std::function<bool(const Operands&)>& fails, int budget)
      : now_(std::move(nested)), fails_(fails), budget_(budget) {}

  Operands run() {
    for (bool smaller = true; smaller && budget_ > 0;) {
      smaller = false;
      for (auto& operand : now_.operands) {
        smaller |= drop_from(operand, 0);
        for (Polygon& polygon : operand) smaller |= drop_from(polygon, 1);
        for (Polygon& polygon : operand) {
          for (Ring& ring : polygon) smaller |= drop_from(ring, 3);
        }
      }
    }
    return to_flat(now_);
  }

 private:
  // Drops runs of elements, long ones first, while the case still fails. True if any could be dropped.
  template <typename T>
  bool drop_from(std::vector<T>& list, std::size_t keep) {
    bool dropped = false;
    for (std::size_t run = list.size(); run > 0; run /= 2) {
      for (std::size_t i = 0; i + run <= list.size() && list.size() >= keep + run && budget_ > 0;) {
        const std::vector<T> before = list;
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(i), list.begin() + static_cast<std::ptrdiff_t>(i + run));
        --budget_;
        if (fails_(to_flat(now_))) {
          dropped = true;
        } else {
          list = before;
          ++i;
        }
      }
    }
    return dropped;
  }

  Nested now_;
  const std::function<bool(const Operands&)>& fails_;
  int budget_;
};

}  // namespace

Operands shrink(Operands operands, const std::function<bool(const Operands&)>& fails, int budget) {
  return Shrinker(to_nested(operands), fails, budget).run();
}

}  // namespace oblast::generators
