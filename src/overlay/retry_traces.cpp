#include "overlay/retry_traces.h"

#include <algorithm>
#include <mutex>
#include <queue>

#include "noding/pair_finder.h"
#include "overlay/edge_conflict.h"

namespace oblast {
namespace {

using noding::Box;

/// Edges that follow one another and have restored vertices between them; any other edge is a stretch by itself.
struct Stretch {
  std::uint32_t first;  ///< first vertex
  std::uint32_t last;   ///< the next that is not restored
  Box box;              ///< of all its vertices: its edges stay in there whatever is taken out
};

class Retry {
 public:
  explicit Retry(Rings& rings)
      : rings_(rings), before_(rings.points.size()), after_(rings.points.size()), stretch_of_(rings.points.size()) {
    link();
    find_stretches();
    find_near();
  }

  /// Flags what is to be taken out as trace.
  void run() {
    const auto later = [&](std::uint32_t p, std::uint32_t q) {
      return lexicographically_less(rings_.points[q], rings_.points[p]);
    };
    std::priority_queue<std::uint32_t, Array<std::uint32_t>, decltype(later)> queue(later);
    Array<std::uint8_t> waits(rings_.points.size(), 0);
    const auto push = [&](std::uint32_t stretch) {
      for_each_edge(stretch, [&](std::uint32_t v) {
        if (!is_restored(v) || waits[v]) return;
        waits[v] = 1;
        queue.push(v);
      });
    };
    for (std::uint32_t s = 0; s < stretches_.size(); ++s) push(s);
    while (!queue.empty()) {
      const std::uint32_t v = queue.top();
      queue.pop();
      waits[v] = 0;
      if (is_needed(v)) continue;
      rings_.flags[v] = trace_vertex;
      after_[before_[v]] = after_[v];
      before_[after_[v]] = before_[v];
      for_each_near(stretch_of_[v], push);  // what it was in the way of
    }
  }

 private:
  bool is_restored(std::uint32_t v) const { return (rings_.flags[v] & restored_vertex) != 0; }

  void link() {
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      const std::uint32_t begin = rings_.begin(r), end = rings_.ends[r];
      for (std::uint32_t v = begin; v < end; ++v) {
        before_[v] = (v == begin ? end : v) - 1;
        after_[v] = v + 1 == end ? begin : v + 1;
      }
    }
  }

  void find_stretches() {
    for (std::uint32_t v = 0; v < rings_.points.size(); ++v) {
      if (is_restored(v)) continue;  // a ring always has vertices of the input
      Stretch stretch{v, v, Box::of(rings_.points[v], rings_.points[v])};
      do {
        stretch_of_[stretch.last] = static_cast<std::uint32_t>(stretches_.size());
        stretch.last = after_[stretch.last];
        stretch.box = stretch.box.joined(rings_.points[stretch.last]);
      } while (is_restored(stretch.last));
      stretches_.push_back(stretch);
    }
  }

  /// Pairs of stretches that may meet, but for those of two single edges.
  void find_near() {
    Array<Point> corners;
    LargeArray<noding::Run> runs;
    constexpr noding::Group single = noding::any_group + 1;
    for (std::uint32_t s = 0; s < stretches_.size(); ++s) {
      const auto& [first, last, box] = stretches_[s];
      corners.insert(corners.end(), {{box.x0, box.y0}, {box.x1, box.y1}});
      runs.push_back({box, 2 * s, 2 * s + 1, after_[first] == last ? single : noding::any_group});
    }
    std::mutex mutex;
    const auto visit = [&](std::span<const noding::RunPair> pairs) {
      const std::lock_guard lock(mutex);
      for (const noding::RunPair& pair : pairs) {
        near_.push_back({pair.first_p / 2, pair.first_q / 2});
        near_.push_back({pair.first_q / 2, pair.first_p / 2});
      }
    };
    noding::find_pairs(corners, std::move(runs), visit, noding::PairGoal::boxes);
    for (std::uint32_t s = 0; s < stretches_.size(); ++s) near_.push_back({s, s});
    std::sort(near_.begin(), near_.end());
    near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
  }

  /// Itself included.
  template <class Visit>
  void for_each_near(std::uint32_t stretch, const Visit& visit) const {
    auto near = std::lower_bound(near_.begin(), near_.end(), Near{stretch, 0});
    for (; near != near_.end() && near->stretch == stretch; ++near) visit(near->other);
  }

  /// Calls visit for the first vertices of the edges that a stretch has now.
  template <class Visit>
  void for_each_edge(std::uint32_t stretch, const Visit& visit) const {
    std::uint32_t v = stretches_[stretch].first;
    do {
      visit(v);
      v = after_[v];
    } while (v != stretches_[stretch].last);
  }

  /// Whether the rest of the result is in the way of an edge from the vertex before v to the one after it.
  bool is_needed(std::uint32_t v) const {
    const std::uint32_t first = before_[v], last = after_[v];
    const Point &a = rings_.points[first], &b = rings_.points[v], &c = rings_.points[last];
    const Box box = Box::of(a, c), swept = box.joined(b);
    const auto lies_between = [&](const Point& p) {
      if (p == a || p == b || p == c) return false;
      PointInRing query(p);
      query.add_edge(a, b);
      query.add_edge(b, c);
      query.add_edge(c, a);
      return query.is_inside();
    };
    bool needed = false;
    for_each_near(stretch_of_[v], [&](std::uint32_t other) {
      if (needed || !stretches_[other].box.meets(swept)) return;
      for_each_edge(other, [&](std::uint32_t e) {
        if (needed || e == first || e == v) return;
        const Point &p = rings_.points[e], &q = rings_.points[after_[e]];
        const Box edge = Box::of(p, q);
        if (!edge.meets(swept)) return;
        needed = (edge.meets(box) && in_conflict(a, c, p, q)) || lies_between(p) || lies_between(q);
      });
    });
    return needed;
  }

  struct Near {
    std::uint32_t stretch, other;
    auto operator<=>(const Near&) const = default;
  };

  Rings& rings_;
  Array<std::uint32_t> before_, after_;  ///< by vertex, along its ring
  Array<std::uint32_t> stretch_of_;      ///< by vertex, of the edge that starts there
  Array<Stretch> stretches_;
  Array<Near> near_;  ///< in order
};

}  // namespace

Rings retry_traces(Rings rings) {
  Retry(rings).run();
  return without(rings, trace_vertex);
}

}  // namespace oblast
