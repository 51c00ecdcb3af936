#include "classics/round_clip.h"

#include <algorithm>
#include <cmath>

#include "base/call_memory.h"
#include "classics/clearance.h"
#include "exact/intersection_point.h"
#include "exact/orientation.h"

namespace oblast::internal::classics {
namespace {

struct Cut {
  std::uint32_t line;  ///< an edge of the subject, or a side of the window
  Point at;
  bool rounded;
};

/// Rounds the crossings. Every crossing is a vertex of the result, so all cuts are known.
class Rounding {
 public:
  Rounding(const HalfPlaneClip& clip, const Array<Ring>& subject, const ConvexWindow& window)
      : clip_(clip), subject_(subject), window_(window) {}

  Point round(const ClipVertex& v) {
    const std::uint32_t edge = std::min(v.first, v.second), side = std::max(v.first, v.second) - clip_.subject_edges();
    const Line e = clip_.line(edge), s = window_.sides[side];
    const Point x = exact::intersection_point(e.p, e.q, s.p, s.q);
    // A cut exactly at a vertex inside the side is not rounded.
    const auto& straight = window_.straight[side];
    const auto same = std::find(straight.begin(), straight.end(), x);
    const bool exact_vertex = same != straight.end() && exact::orientation(e.p, e.q, x) == 0;
    collapsed_ |= !exact_vertex && (same != straight.end() || x == e.p || x == e.q || x == s.p || x == s.q);
    edge_cuts_.push_back({edge, x, !exact_vertex});
    if (!exact_vertex) side_cuts_.push_back({side, x, true});
    ++meetings_;
    return x;
  }

  std::uint64_t meetings() const { return meetings_; }

  bool is_clear() {
    const auto rounded = [](const Cut& c) { return c.rounded; };
    if (collapsed_) return false;
    if (std::none_of(edge_cuts_.begin(), edge_cuts_.end(), rounded)) return true;
    add_exact_cuts();
    noding::Strands strands;
    std::uint32_t edge = 0;
    std::size_t next = 0;
    sort(edge_cuts_);
    for (const Ring& ring : subject_) {
      for (const Point& p : ring.points) {
        if (!add(strands, p, edge_cuts_, next, edge)) return false;
        ++edge;
      }
      close(strands, {1, 0});
    }
    next = 0;
    sort(side_cuts_);
    for (std::uint32_t side = 0; side < window_.sides.size(); ++side)
      if (!add(strands, window_.sides[side].p, side_cuts_, next, side)) return false;
    close(strands, {0, 1});
    return classics::is_clear(strands);
  }

 private:
  /// Adds cuts at vertices exactly on edges of the other contour: subject vertices on sides, window corners on crossed
  /// edges.
  void add_exact_cuts() {
    for (std::uint32_t side = 0; side < window_.sides.size(); ++side) {
      for (const Point& p : window_.straight[side]) side_cuts_.push_back({side, p, false});
      const Line& s = window_.sides[side];
      for (const Point& p : clip_.touches()[side])
        if (is_inside(p, s)) side_cuts_.push_back({side, p, false});
    }
    Array<std::uint32_t> crossed;
    for (const Cut& c : edge_cuts_) crossed.push_back(c.line);
    std::sort(crossed.begin(), crossed.end());
    crossed.erase(std::unique(crossed.begin(), crossed.end()), crossed.end());
    for (const std::uint32_t edge : crossed) {
      const Line e = clip_.line(edge);
      for (const Line& s : window_.sides)
        if (exact::orientation(e.p, e.q, s.p) == 0 && is_inside(s.p, e)) edge_cuts_.push_back({edge, s.p, false});
    }
  }

  /// REQUIRES: p is on the line of s.
  static bool is_inside(const Point& p, const Line& s) {
    const bool forward = lexicographically_less(s.p, s.q);
    const Point &low = forward ? s.p : s.q, &high = forward ? s.q : s.p;
    return lexicographically_less(low, p) && lexicographically_less(p, high);
  }

  void sort(Array<Cut>& cuts) const {
    const bool sides = &cuts == &side_cuts_;
    std::sort(cuts.begin(), cuts.end(), [&](const Cut& p, const Cut& q) {
      if (p.line != q.line) return p.line < q.line;
      const Line l = clip_.line(sides ? clip_.subject_edges() + p.line : p.line);
      if (p.at.x != q.at.x) return (p.at.x < q.at.x) == (l.p.x < l.q.x);
      if (p.at.y != q.at.y) return (p.at.y < q.at.y) == (l.p.y < l.q.y);
      return p.rounded < q.rounded;
    });
  }

  /// Adds the first vertex of a line and its cuts. False if two of them were rounded to the same point.
  static bool add(noding::Strands& strands, const Point& p, const Array<Cut>& cuts, std::size_t& next,
                  std::uint32_t line) {
    strands.points.push_back(p);
    strands.flags.push_back(0);
    for (; next < cuts.size() && cuts[next].line == line; ++next) {
      if (cuts[next].at == strands.points.back()) {
        if (cuts[next].rounded || strands.flags.back() != 0) return false;
        continue;
      }
      strands.points.push_back(cuts[next].at);
      strands.flags.push_back(cuts[next].rounded ? noding::added_flag : 0);
    }
    return true;
  }

  static void close(noding::Strands& strands, noding::Winding change) {
    const std::uint32_t begin = strands.ends.empty() ? 0 : strands.ends.back();
    const Point first = strands.points[begin];
    strands.points.push_back(first);
    strands.flags.push_back(0);
    for (std::size_t v = begin; v + 1 < strands.points.size(); ++v)
      if ((strands.flags[v] | strands.flags[v + 1]) & noding::added_flag) strands.flags[v] |= noding::moved_flag;
    strands.close_strand(change, noding::any_group);
  }

  const HalfPlaneClip& clip_;
  const Array<Ring>& subject_;
  const ConvexWindow& window_;
  Array<Cut> edge_cuts_, side_cuts_;
  std::uint64_t meetings_ = 0;
  bool collapsed_ = false;
};

}  // namespace

bool has_safe_magnitudes(const Array<Ring>& rings) {
  const auto safe = [](double coordinate) {
    const double magnitude = std::fabs(coordinate);
    return magnitude == 0 || (magnitude >= crossing_smallest && magnitude <= crossing_largest);
  };
  return std::all_of(rings.begin(), rings.end(), [&](const Ring& ring) {
    return std::all_of(ring.points.begin(), ring.points.end(), [&](const Point& p) { return safe(p.x) && safe(p.y); });
  });
}

bool round_clip(const HalfPlaneClip& clip, const Array<Ring>& subject, const ConvexWindow& window,
                window::Contours& contours, std::uint64_t& meetings) {
  Rounding rounding(clip, subject, window);
  std::uint32_t begin = 0;
  for (const std::uint32_t end : clip.ends()) {
    for (std::uint32_t v = begin; v < end; ++v) {
      const ClipVertex& vertex = clip.vertices()[v];
      contours.add(vertex.is_crossing() ? rounding.round(vertex) : vertex.at);
    }
    contours.close();
    begin = end;
  }
  meetings = rounding.meetings();
  return rounding.is_clear();
}

}  // namespace oblast::internal::classics
