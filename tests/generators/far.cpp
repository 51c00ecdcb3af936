// A case with others far away: squares that do not meet its polygons.
#include "generators/far.h"

#include <oblast/domain.h>

#include <algorithm>
#include <cmath>

#include "generators/soup.h"
#include "generators/trial.h"

namespace oblast::generators {
namespace {

class Squares {
 public:
  Squares(const Operands& operands, std::uint64_t seed) : random_(seed), all_(box_of(operands)) {
    add_boxes_of_polygons(boxes_, operands.a);
    add_boxes_of_polygons(boxes_, operands.b);
    if (all_.empty()) all_ = {1, 1, 2, 2};
    largest_ = std::max({std::abs(all_.x0), std::abs(all_.x1), std::abs(all_.y0), std::abs(all_.y1), domain_smallest});
    size_ = std::max({all_.x1 - all_.x0, all_.y1 - all_.y0, 0x1p-44 * largest_, 0x1p10 * domain_smallest});
  }

  FarSquares run() {
    // In most cases enough squares to fill batches; in some cases enough to exceed every threshold of the library. Few,
    // if some are so far away that the whole case is smaller than a unit in the last place there: then nothing keeps
    // clear of anything.
    very_far_ = random_.one_in(12);
    const int count = very_far_             ? random_.between(1, 60)
                      : random_.one_in(128) ? 4500
                      : random_.one_in(16)  ? random_.between(600, 1500)
                                            : random_.between(8, 140);
    while (made_ < count) {
      const int row = std::min(count - made_, random_.between(1, 1 + count / 3));
      switch (random_.below(4)) {
        case 0:
          add_in_gaps(row);
          break;
        case 1:
          add_far_away(row);
          break;
        default:
          add_beside(row);
      }
      made_ += row;
    }
    return std::move(squares_);
  }

 private:
  // In a row along one of the four sides.
  void add_beside(int row) {
    const double step = size_ / (2.0 * row), side = step * random_.in(0.2, 0.9), gap = size_ * random_.in(0.1, 0.5);
    const int where = random_.below(4);
    for (int i = 0; i < row; ++i) {
      const double along = i * step;
      if (where == 0) add(all_.x0 - gap - along - side, all_.y0, side);
      if (where == 1) add(all_.x1 + gap + along, all_.y0, side);
      if (where == 2) add(all_.x0 + along, all_.y0 - gap - side, side);
      if (where == 3) add(all_.x0 + along, all_.y1 + gap, side);
    }
  }

  void add_in_gaps(int row) {
    const double side = size_ * (random_.one_in(2) ? 0.003 : 0.03);
    for (int i = 0; i < row; ++i) add(random_.in(all_.x0, all_.x1), random_.in(all_.y0, all_.y1), side);
  }

  // So far away that a unit in the last place is many units of the case, or larger than the whole case.
  void add_far_away(int row) {
    static constexpr int exponents[] = {2, 4, 10, 20, 40, 60, 200, 500};
    const double place = std::ldexp(largest_, exponents[random_.below(very_far_ ? 8 : 4)]),
                 side = place * random_.in(0.1, 0.7) / row;
    const double x = random_.one_in(2) ? place : -place, y = random_.one_in(2) ? place : -place;
    for (int i = 0; i < row; ++i) add(x + i * side * 1.3, random_.one_in(3) ? all_.y0 : y, side);
  }

  // Adds a square, if it is in the domain and meets no polygon. Some are repeated, some overlap the one before.
  void add(double x, double y, double side) {
    put(x, y, side);
    if (random_.one_in(4)) put(x, y, side);
    if (random_.one_in(6)) put(x + side / 2, y + side / 3, side);
  }

  void put(double x, double y, double side) {
    const auto into_domain = [](double c) { return std::abs(c) < domain_smallest ? 0.0 : c; };
    const Box box{into_domain(x), into_domain(y), into_domain(x + side), into_domain(y + side)};
    if (!in_domain(box.x0) || !in_domain(box.y0) || !in_domain(box.x1) || !in_domain(box.y1)) return;
    if (box.meets(all_) && std::any_of(boxes_.begin(), boxes_.end(), [&](const Box& b) { return b.meets(box); }))
      return;
    Ring ring = rectangle(box.x0, box.y0, box.x1, box.y1);
    if (random_.one_in(4)) ring = reversed(std::move(ring));
    add_polygon(random_.one_in(3) ? squares_.b : squares_.a, ring);
  }

  Random random_;
  Box all_;
  std::vector<Box> boxes_;
  double largest_ = 0, size_ = 0;
  bool very_far_ = false;
  int made_ = 0;
  FarSquares squares_;
};

}  // namespace

FarSquares far_squares(const Operands& operands, std::uint64_t seed) { return Squares(operands, seed).run(); }

Operands with_squares(const Operands& operands, const FarSquares& squares, std::uint64_t seed) {
  Operands both = operands;
  append(both.a, squares.a);
  append(both.b, squares.b);
  // `positive`: directions stay as they are, whatever the rule.
  return {shuffled(both.a, FillRule::positive(), seed), shuffled(both.b, FillRule::positive(), seed + 1)};
}

}  // namespace oblast::generators
