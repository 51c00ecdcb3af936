#include "noding/monotone_runs.h"

namespace oblast::noding {
namespace {

constexpr Group settled_group = 1;

/// The quadrant an edge points to, as bits that two edges of one run may not contradict each other in.
struct Heading {
  bool right = false, left = false, up = false, down = false;

  static Heading of(const Point& p, const Point& q) { return {q.x > p.x, q.x<p.x, q.y> p.y, q.y < p.y}; }
  bool contradicts(const Heading& o) const {
    return (right && o.left) || (left && o.right) || (up && o.down) || (down && o.up);
  }
  void join(const Heading& o) {
    right |= o.right;
    left |= o.left;
    up |= o.up;
    down |= o.down;
  }
};

}  // namespace

std::vector<Run> monotone_runs(const Strands& strands, Grouping grouping) {
  std::vector<Run> runs;
  runs.reserve(strands.points.size() / 2 + 16);
  const auto& points = strands.points;
  const auto group_of = [&](std::size_t strand, std::uint32_t edge) {
    if (grouping == Grouping::none) return any_group;
    if (grouping == Grouping::by_strand)
      return strands.simplicity[strand] == Simplicity::known ? strands.group[strand] : any_group;
    return (strands.flags[edge] & moved_flag) ? any_group : settled_group;
  };
  for (std::size_t s = 0; s < strands.size(); ++s) {
    const std::uint32_t last_vertex = strands.ends[s] - 1;
    for (std::uint32_t first = strands.begin(s); first < last_vertex;) {
      const Group group = group_of(s, first);
      Heading heading = Heading::of(points[first], points[first + 1]);
      std::uint32_t last = first + 1;
      while (last < last_vertex && last - first < longest_run) {
        const Heading next = Heading::of(points[last], points[last + 1]);
        if (heading.contradicts(next) || group_of(s, last) != group) break;
        heading.join(next);
        ++last;
      }
      runs.push_back({Box::of(points[first], points[last]), first, last, group});
      first = last;
    }
  }
  return runs;
}

}  // namespace oblast::noding
