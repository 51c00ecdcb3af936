#include "oblast/roads.h"

#include <algorithm>
#include <cmath>

#include "oblast/fires_random.h"

namespace oblast::app {

namespace {

constexpr double cell = 5000, step_of_road = 40;  // metres
constexpr Point origin{4'000'000, 3'000'000};     // in the middle of Europe
constexpr double segments_of_town = 700;          // with its two roads, roughly

Point rounded(double x, double y) { return {std::round(x * 100) / 100, std::round(y * 100) / 100}; }

// Collects lines until the network has all its segments.
class Writer {
 public:
  Writer(RoadNetwork& network, std::uint32_t segments) : network_(network), left_(segments) {}

  bool is_full() const { return left_ == 0; }
  void begin(const char* kind) { kind_ = kind, line_.clear(); }
  void add(const Point& p) {
    if (line_.size() > left_ || (!line_.empty() && line_.back() == p)) return;
    line_.push_back(p);
  }
  void end() {
    if (line_.size() >= 2) {
      network_.vertices.insert(network_.vertices.end(), line_.begin(), line_.end());
      network_.ends.push_back(static_cast<std::uint32_t>(network_.vertices.size()));
      network_.kinds.emplace_back(kind_);
      left_ -= line_.size() - 1;
    }
    line_.clear();
  }

 private:
  RoadNetwork& network_;
  std::size_t left_;
  const char* kind_ = "";
  std::vector<Point> line_;
};

// The junctions of a town. They depend on the seed and the cell alone, so that neighbours know them, too.
class Town {
 public:
  Town(std::uint64_t seed, std::uint32_t column, std::uint32_t row) : random_(mix(mix(seed, column), row)) {
    columns_ = 8 + random_.below(9), rows_ = 8 + random_.below(9);
    const Point middle{origin.x + (column + random_.uniform(0.35, 0.65)) * cell,
                       origin.y + (row + random_.uniform(0.35, 0.65)) * cell};
    const double slope = random_.uniform(-0.6, 0.6), length = std::sqrt(1 + slope * slope);
    const Point along{1 / length, slope / length};
    const std::vector<double> x = streets(columns_), y = streets(rows_);
    for (std::uint32_t j = 0; j < rows_; ++j)
      for (std::uint32_t i = 0; i < columns_; ++i) {
        const double u = x[i] - x.back() / 2 + random_.uniform(-5, 5), v = y[j] - y.back() / 2 + random_.uniform(-5, 5);
        junctions_.push_back(rounded(middle.x + u * along.x - v * along.y, middle.y + u * along.y + v * along.x));
      }
  }

  Point west() const { return at(0, rows_ / 2); }
  Point east() const { return at(columns_ - 1, rows_ / 2); }
  Point south() const { return at(columns_ / 2, 0); }
  Point north() const { return at(columns_ / 2, rows_ - 1); }

  void write_streets(Writer& writer) {
    for (std::uint32_t j = 0; j < rows_; ++j) {
      writer.begin("street");
      for (std::uint32_t i = 0; i < columns_; ++i) go_on(writer, i > 0 ? at(i - 1, j) : at(i, j), at(i, j));
      writer.end();
    }
    for (std::uint32_t i = 0; i < columns_; ++i) {
      writer.begin("street");
      for (std::uint32_t j = 0; j < rows_; ++j) go_on(writer, j > 0 ? at(i, j - 1) : at(i, j), at(i, j));
      writer.end();
    }
  }

  // A winding road: its deviation from the straight line is a random walk of its slope that ends at `to`.
  void write_road(Writer& writer, const Point& from, const Point& to) {
    const double dx = to.x - from.x, dy = to.y - from.y, length = std::sqrt(dx * dx + dy * dy);
    const auto steps = static_cast<std::size_t>(std::max(1.0, length / step_of_road));
    std::vector<double> aside{0};
    double slope = 0;
    for (std::size_t i = 0; i < steps; ++i) {
      slope = 0.93 * slope + random_.uniform(-0.25, 0.25);
      aside.push_back(aside.back() + slope * length / static_cast<double>(steps));
    }
    writer.begin("road");
    writer.add(from);
    for (std::size_t i = 1; i < steps; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(steps),
                   side = (aside[i] - t * aside.back()) / length;
      writer.add(rounded(from.x + t * dx - side * dy, from.y + t * dy + side * dx));
    }
    writer.add(to);
    writer.end();
  }

 private:
  const Point& at(std::uint32_t i, std::uint32_t j) const { return junctions_[j * columns_ + i]; }

  std::vector<double> streets(std::uint32_t count) {
    std::vector<double> places{0};
    while (places.size() < count) places.push_back(places.back() + random_.uniform(50, 120));
    return places;
  }

  // To the next junction of the street: straight, by a bend, or not at all.
  void go_on(Writer& writer, const Point& from, const Point& to) {
    if (from != to && random_.chance(0.1)) {
      writer.end();
      writer.begin("street");
    } else if (from != to && random_.chance(0.3)) {
      writer.add(rounded((from.x + to.x) / 2 + random_.uniform(-8, 8), (from.y + to.y) / 2 + random_.uniform(-8, 8)));
    }
    writer.add(to);
  }

  Random random_;
  std::uint32_t columns_ = 0, rows_ = 0;
  std::vector<Point> junctions_;
};

}  // namespace

RoadNetwork generate_roads(std::uint32_t segments, std::uint64_t seed) {
  RoadNetwork network;
  Writer writer(network, segments);
  const auto columns = static_cast<std::uint32_t>(std::max(1.0, std::sqrt(segments / segments_of_town)));
  for (std::uint32_t row = 0; !writer.is_full(); ++row) {
    for (std::uint32_t column = 0; column < columns && !writer.is_full(); ++column) {
      Town town(seed, column, row);
      town.write_streets(writer);
      if (column + 1 < columns) town.write_road(writer, town.east(), Town(seed, column + 1, row).west());
      town.write_road(writer, town.north(), Town(seed, column, row + 1).south());
    }
  }
  return network;
}

}  // namespace oblast::app
