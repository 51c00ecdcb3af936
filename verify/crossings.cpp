// Finds places where input edges cross. Cells around the midpoints of edges are halved until they have few edges. Then
// all pairs of edges of a cell are tested.
#include <algorithm>
#include <array>
#include <numeric>

#include "verify/predicates.h"
#include "verify/probes.h"

namespace oblast::verify {
namespace {

constexpr std::size_t few = 48;                // with up to this many edges in a cell, all pairs are tested
constexpr std::size_t pairs_in_a_crowd = 500;  // number of pairs that are tested if a cell cannot be divided
constexpr int most_depth = 60;

class Search {
 public:
  Search(const Segments& segments, std::size_t most, std::mt19937_64& random)
      : segments_(segments), most_(most), random_(random) {}

  std::vector<Point> run(std::vector<Point> seeds) {
    std::vector<std::uint32_t> all(segments_.input_count());
    std::iota(all.begin(), all.end(), 0u);
    descend(segments_.box(), all, seeds, 0);
    return std::move(found_);
  }

 private:
  void descend(const Box& box, const std::vector<std::uint32_t>& edges, std::span<Point> seeds, int depth) {
    if (edges.size() <= few || depth == most_depth) return try_pairs(edges);
    const bool wide = box.x1 - box.x0 > box.y1 - box.y0;
    const double middle = wide ? box.x0 / 2 + box.x1 / 2 : box.y0 / 2 + box.y1 / 2;
    const auto lower_end =
        std::partition(seeds.begin(), seeds.end(), [&](const Point& p) { return (wide ? p.x : p.y) < middle; });
    Box lower = box, upper = box;
    (wide ? lower.x1 : lower.y1) = (wide ? upper.x0 : upper.y0) = middle;
    descend_half(lower, edges, std::span(seeds.begin(), lower_end), depth);
    descend_half(upper, edges, std::span(lower_end, seeds.end()), depth);
  }

  void descend_half(const Box& half, const std::vector<std::uint32_t>& edges, std::span<Point> seeds, int depth) {
    if (seeds.empty()) return;
    std::vector<std::uint32_t> inside;
    std::copy_if(edges.begin(), edges.end(), std::back_inserter(inside),
                 [&](std::uint32_t e) { return may_reach(segments_[e], half, 0); });
    descend(half, inside, seeds, depth + 1);
  }

  void try_pairs(const std::vector<std::uint32_t>& edges) {
    if (edges.size() > few) {
      for (std::size_t i = 0; i < pairs_in_a_crowd; ++i) {
        try_pair(edges[random_() % edges.size()], edges[random_() % edges.size()]);
      }
      return;
    }
    for (std::size_t i = 0; i < edges.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) try_pair(edges[i], edges[j]);
    }
  }

  void try_pair(std::uint32_t i, std::uint32_t j) {
    const Segment &e = segments_[i], &f = segments_[j];
    if (i == j || !meet_badly(e.from, e.to, f.from, f.to)) return;
    const double dx = e.to.x - e.from.x, dy = e.to.y - e.from.y;
    const double fx = f.to.x - f.from.x, fy = f.to.y - f.from.y;
    const double t = ((f.from.x - e.from.x) * fy - (f.from.y - e.from.y) * fx) / (dx * fy - dy * fx);
    if (!(t >= 0 && t <= 1)) return;  // parallel, or the rounding error is too large
    keep({e.from.x + t * dx, e.from.y + t * dy});
  }

  // Keeps each crossing with the same probability.
  void keep(const Point& p) {
    ++count_;
    if (found_.size() < most_) return found_.push_back(p);
    if (const std::size_t place = random_() % count_; place < most_) found_[place] = p;
  }

  const Segments& segments_;
  std::size_t most_, count_ = 0;
  std::mt19937_64& random_;
  std::vector<Point> found_;
};

}  // namespace

std::vector<Point> some_crossings(const Segments& segments, std::size_t most, std::mt19937_64& random) {
  constexpr std::uint32_t most_seeds = 300'000;
  const std::uint32_t edges = segments.input_count(), count = std::min(edges, most_seeds);
  std::vector<Point> seeds;
  seeds.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const Segment& s = segments[static_cast<std::uint32_t>(static_cast<double>(i) / count * edges)];
    const double t = uniform(random);
    seeds.push_back({s.from.x + t * (s.to.x - s.from.x), s.from.y + t * (s.to.y - s.from.y)});
  }
  return Search(segments, most, random).run(std::move(seeds));
}

}  // namespace oblast::verify
