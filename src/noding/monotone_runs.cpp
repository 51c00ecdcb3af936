#include "noding/monotone_runs.h"

#include "memory/large_pages.h"

namespace oblast::noding {
namespace {

constexpr Group settled_group = 1;

/// Where an edge points: right, left, up, down, a bit each.
unsigned heading(const Point& p, const Point& q) {
  return static_cast<unsigned>(q.x > p.x) | static_cast<unsigned>(q.x < p.x) << 1 |
         static_cast<unsigned>(q.y > p.y) << 2 | static_cast<unsigned>(q.y < p.y) << 3;
}

/// Right and left, or up and down.
bool turns_back(unsigned headings) { return (headings & headings >> 1 & 0b0101) != 0; }

}  // namespace

std::vector<Run> monotone_runs(const Strands& strands, Grouping grouping) {
  std::vector<Run> runs;
  reserve_in_large_pages(runs, strands.points.size() / 2 + 16);
  const auto& points = strands.points;
  const auto group_of = [&](std::size_t strand) {
    const bool grouped = grouping == Grouping::by_strand && strands.simplicity[strand] == Simplicity::known;
    return grouped ? strands.group[strand] : any_group;
  };
  const auto piece_moved = [&](std::uint32_t edge) { return (strands.flags[edge] & moved_flag) != 0; };
  for (std::size_t s = 0; s < strands.size(); ++s) {
    const std::uint32_t last_vertex = strands.ends[s] - 1;
    const Group group = group_of(s);
    for (std::uint32_t first = strands.begin(s); first < last_vertex;) {
      const std::uint32_t longest = std::min(first + longest_run, last_vertex);
      const bool by_moved = grouping == Grouping::by_moved, moved = by_moved && piece_moved(first);
      unsigned headings = heading(points[first], points[first + 1]);
      std::uint32_t last = first + 1;
      for (; last < longest; ++last) {
        headings |= heading(points[last], points[last + 1]);
        if (turns_back(headings) || (by_moved && piece_moved(last) != moved)) break;
      }
      const Group of_run = by_moved ? (moved ? any_group : settled_group) : group;
      runs.push_back({Box::of(points[first], points[last]), first, last, of_run});
      first = last;
    }
  }
  return runs;
}

}  // namespace oblast::noding
