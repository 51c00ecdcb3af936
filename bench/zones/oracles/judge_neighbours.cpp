#include <algorithm>
#include <cmath>

#include "verify/zones.h"
#include "zones/oracles/frame.h"
#include "zones/oracles/neighbours.h"
#include "zones/oracles/objects.h"

namespace zones {

using namespace oblast;

namespace {

bool is_less(const Point& p, const Point& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; }

struct Pair {
  std::uint32_t i, j;
  double length;
};
bool is_less(const Pair& p, const Pair& q) { return p.i != q.i ? p.i < q.i : p.j < q.j; }

struct Diagram {
  std::vector<Pair> pairs;      ///< ascending
  std::vector<Point> vertices;  ///< inside the frame, ascending
};

Diagram read_diagram(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::vector<std::uint64_t> counts(2);
  buffers::transfer(in, counts);
  if (!in) throw std::runtime_error(path + ": no file of neighbours");
  std::vector<std::uint32_t> ends(2 * counts[0]);
  std::vector<double> lengths(counts[0]);
  Diagram diagram;
  diagram.vertices.resize(counts[1]);
  buffers::transfer(in, ends);
  buffers::transfer(in, lengths);
  buffers::transfer(in, diagram.vertices);
  if (!in) throw std::runtime_error(path + ": ends too early");
  for (std::size_t k = 0; k < lengths.size(); ++k) diagram.pairs.push_back({ends[2 * k], ends[2 * k + 1], lengths[k]});
  return diagram;
}

/// Rows that have an edge in common, one each way.
std::vector<Pair> pairs_of(const FeatureSet& rows) {
  struct Edge {
    Point a, b;  // ascending
    std::uint32_t row;
  };
  std::vector<Edge> edges;
  const FeatureView view = rows;
  for (std::uint32_t r = 0; r < rows.size(); ++r)
    for (std::uint32_t p = view.feature_begin(r); p < view.feature_end(r); ++p)
      for (const std::span<const Point> ring : view.regions.polygon(p).contours())
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
          edges.push_back(is_less(a, b) ? Edge{a, b, r} : Edge{b, a, r});
        }
  std::ranges::sort(edges, [](const Edge& e, const Edge& f) {
    if (e.a != f.a) return is_less(e.a, f.a);
    return e.b != f.b ? is_less(e.b, f.b) : e.row < f.row;
  });
  std::vector<Pair> pieces, pairs;
  for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
    const Edge &e = edges[k], &f = edges[k + 1];
    if (e.a == f.a && e.b == f.b) pieces.push_back({e.row, f.row, std::hypot(e.b.x - e.a.x, e.b.y - e.a.y)});
  }
  std::ranges::sort(pieces, [](const Pair& p, const Pair& q) { return is_less(p, q); });
  for (const Pair& p : pieces) {
    if (!pairs.empty() && pairs.back().i == p.i && pairs.back().j == p.j)
      pairs.back().length += p.length;
    else
      pairs.push_back(p);
  }
  return pairs;
}

std::vector<Point> vertices_of(const FeatureSet& rows, const FrameBox& frame) {
  std::vector<Point> vertices;
  for (const Point& p : rows.regions.points)
    if (frame.has_inside(p.x, p.y)) vertices.push_back(p);
  std::ranges::sort(vertices, [](const Point& p, const Point& q) { return is_less(p, q); });
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

class Comparison {
 public:
  Comparison(double rounding) : rounding_(rounding) {}

  void compare(const std::vector<Pair>& ours, const std::vector<Pair>& theirs) {
    auto p = ours.begin();
    auto q = theirs.begin();
    while (p != ours.end() || q != theirs.end()) {
      if (q == theirs.end() || (p != ours.end() && is_less(*p, *q))) {
        count((p++)->length, extra_pairs_);
      } else if (p == ours.end() || is_less(*q, *p)) {
        count((q++)->length, missing_pairs_);
      } else {
        largest_ = std::max(largest_, std::abs(p->length - q->length));
        ++p, ++q, ++pairs_;
      }
    }
  }

  void compare(const std::vector<Point>& ours, const std::vector<Point>& theirs) {
    const auto is_near = [&](const Point& p, const std::vector<Point>& others) {
      const auto begin = std::ranges::lower_bound(others, p.x - rounding_, {}, &Point::x);
      for (auto q = begin; q != others.end() && q->x <= p.x + rounding_; ++q)
        if (*q != p && std::abs(q->y - p.y) <= rounding_) return true;
      return false;
    };
    const auto without = [&](const std::vector<Point>& some, const std::vector<Point>& others, std::uint64_t& count) {
      std::vector<Point> left;
      std::ranges::set_difference(some, others, std::back_inserter(left),
                                  [](const Point& p, const Point& q) { return is_less(p, q); });
      for (const Point& p : left) ++(is_near(p, theirs) ? excused_ : count);
      return some.size() - left.size();
    };
    vertices_ = without(theirs, ours, missing_vertices_);
    without(ours, theirs, extra_vertices_);
  }

  nlohmann::json report() const {
    return {{"pairs", pairs_},       {"missing_pairs", missing_pairs_},       {"extra_pairs", extra_pairs_},
            {"vertices", vertices_}, {"missing_vertices", missing_vertices_}, {"extra_vertices", extra_vertices_},
            {"excused", excused_},   {"lengths", largest_ / rounding_}};
  }

 private:
  void count(double length, std::uint64_t& faults) { ++(length <= rounding_ ? excused_ : faults); }

  double rounding_;
  double largest_ = 0;
  std::uint64_t pairs_ = 0, missing_pairs_ = 0, extra_pairs_ = 0, excused_ = 0;
  std::uint64_t vertices_ = 0, missing_vertices_ = 0, extra_vertices_ = 0;
};

}  // namespace

nlohmann::json judge_neighbours(const std::string& shapes, const std::string& neighbours) {
  const buffers::Shapes read = buffers::read_shapes(shapes);
  const Objects objects(read);
  ZoneStatistics statistics;
  const FeatureSet rows = objects.zones(0, statistics);
  const verify::ZoneObjects judged(objects.view());
  const auto fault = verify::check_zone_cover({judged, objects.frame(), rows, rows.keys}, {statistics.rounding, true});
  const Diagram theirs = read_diagram(neighbours);
  Comparison comparison(statistics.rounding);
  comparison.compare(pairs_of(rows), theirs.pairs);
  comparison.compare(vertices_of(rows, FrameBox(read)), theirs.vertices);
  nlohmann::json report = comparison.report();
  report["objects"] = objects.size();
  report["error"] = statistics.error;
  report["rounding"] = statistics.rounding;
  report["coverage"] = fault ? fault->what : "";
  return report;
}

}  // namespace zones
