// Chooses points. Nothing here needs to be exact, because every point is judged exactly.
#include "verify/probes.h"

#include <oblast/domain.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace oblast::verify {
namespace {

class Chooser {
 public:
  Chooser(const Segments& segments, std::uint64_t seed) : segments_(segments), random_(seed) {
    const Box& box = segments.box();
    extent_ = std::max({box.x1 - box.x0, box.y1 - box.y0, 100 * segments.unit()});
    find_new_vertices();
  }

  void anywhere(std::uint64_t count) {
    const Box& box = segments_.box();
    for (std::uint64_t i = 0; i < count; ++i) {
      const double u = 1.1 * uniform(random_) - 0.05, v = 1.1 * uniform(random_) - 0.05;
      add({box.x0 + u * (box.x1 - box.x0), box.y0 + v * (box.y1 - box.y0)}, ProbeKind::anywhere);
    }
  }

  // Adds points on both sides of edges [first, last), at equal steps.
  void by_edges(std::uint32_t first, std::uint32_t last, std::uint64_t count) {
    for_even_steps(first, last, count / 2, [&](const Segment& s) {
      const double dx = s.to.x - s.from.x, dy = s.to.y - s.from.y, length = std::hypot(dx, dy);
      const double t = uniform(random_), away = distance();
      const Point foot{s.from.x + t * dx, s.from.y + t * dy};
      for (const int side : {-1, 1}) {
        add({foot.x - side * away * (dy / length), foot.y + side * away * (dx / length)}, ProbeKind::by_edge);
      }
    });
  }

  void by_vertices(std::uint32_t first, std::uint32_t last, std::uint64_t count) {
    for_even_steps(first, last, count, [&](const Segment& s) { about(s.from, ProbeKind::by_vertex); });
  }

  // Every other point is a vertex that no operand has, if there is any.
  void at_result_vertices(std::uint64_t count) {
    const std::uint64_t count_new = new_vertices_.empty() ? 0 : count / 2;
    for (std::uint64_t i = 0; i < count_new; ++i) add(step_through_new(i, count_new), ProbeKind::result_vertex);
    for_even_steps(segments_.input_count(), segments_.size(), count - count_new,
                   [&](const Segment& s) { add(s.from, ProbeKind::result_vertex); });
  }

  // Adds crossings that are vertices of the result, and others that were found independently of it.
  void by_crossings(std::uint64_t count) {
    if (count == 0) return;
    const std::vector<Point> places = some_crossings(segments_, count, random_);
    std::uint64_t count_new = new_vertices_.empty() ? 0 : count / 2;
    if (places.empty() && count_new > 0) count_new = count;
    for (std::uint64_t i = 0; i < count_new; ++i) about(step_through_new(i, count_new), ProbeKind::by_crossing);
    if (places.empty()) return;
    for (std::uint64_t i = count_new; i < count; ++i) about(places[i % places.size()], ProbeKind::by_crossing);
  }

  std::vector<Probe> take() { return std::move(probes_); }

 private:
  template <class Visit>
  void for_even_steps(std::uint32_t first, std::uint32_t last, std::uint64_t count, const Visit& visit) {
    if (first == last) return;
    const double step = static_cast<double>(last - first) / static_cast<double>(count);
    for (std::uint64_t i = 0; i < count; ++i) {
      const double at = (static_cast<double>(i) + uniform(random_)) * step;
      visit(segments_[std::min(first + static_cast<std::uint32_t>(at), last - 1)]);
    }
  }

  const Point& step_through_new(std::uint64_t i, std::uint64_t count) const {
    const std::size_t size = new_vertices_.size();
    return size <= count ? new_vertices_[i % size] : new_vertices_[size / count * i];
  }

  // Vertices of the result that are not vertices of an operand.
  void find_new_vertices() {
    std::vector<Point> old;
    old.reserve(segments_.input_count());
    for (std::uint32_t e = 0; e < segments_.input_count(); ++e) old.push_back(segments_[e].from);
    std::sort(old.begin(), old.end(), lexicographically_less);
    for (std::uint32_t e = segments_.input_count(); e < segments_.size(); ++e) {
      const Point& p = segments_[e].from;
      if (!std::binary_search(old.begin(), old.end(), p, lexicographically_less)) new_vertices_.push_back(p);
    }
  }

  double distance() {
    const double unit = segments_.unit(), choice = uniform(random_), u = uniform(random_);
    if (choice < 0.5) return (5 + 45 * u) * unit;
    if (choice < 0.65) return 5 * u * unit;
    return 50 * unit * std::pow(std::max(extent_ / 100 / (50 * unit), 1.0), u);
  }

  void about(const Point& p, ProbeKind kind) {
    const double angle = 2 * std::numbers::pi * uniform(random_), away = distance();
    add({p.x + away * std::cos(angle), p.y + away * std::sin(angle)}, kind);
  }

  // Points outside the domain are left out, because the predicates are not exact for them.
  void add(Point p, ProbeKind kind) {
    if (!in_domain(p.x)) p.x = 0;
    if (!in_domain(p.y)) p.y = 0;
    probes_.push_back({p, kind});
  }

  const Segments& segments_;
  std::mt19937_64 random_;
  double extent_;
  std::vector<Point> new_vertices_;
  std::vector<Probe> probes_;
};

}  // namespace

std::vector<Probe> choose_probes(const Segments& segments, std::uint64_t count, std::uint64_t seed) {
  Chooser chooser(segments, seed);
  const std::uint32_t input = segments.input_count(), all = segments.size();
  chooser.anywhere(count / 10);
  chooser.by_edges(0, input, count * 3 / 10);
  chooser.by_edges(input, all, count / 10);
  chooser.by_vertices(0, input, count / 10);
  chooser.by_vertices(input, all, count / 10);
  chooser.by_crossings(count / 5);
  chooser.at_result_vertices(count / 10);
  return chooser.take();
}

}  // namespace oblast::verify
