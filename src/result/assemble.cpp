#include "result/assemble.h"

#include <algorithm>

#include "base/counting_sort.h"
#include "base/index.h"
#include "base/large_pages.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "plane/smallest_vertex.h"

namespace oblast::internal {
namespace {

/// A ring that is read from a given vertex on.
class Rotation {
 public:
  explicit Rotation(const Rings& rings) : points_(rings.points.data()), begin_(0), end_(0), start_(0) {}
  Rotation(const Rings& rings, std::size_t ring, std::uint32_t start)
      : points_(rings.points.data()), begin_(rings.begin(ring)), end_(rings.ends[ring]), start_(start) {}

  std::size_t size() const { return end_ - begin_; }
  const Point& operator[](std::size_t i) const {
    const std::size_t v = start_ + i;
    return points_[v < end_ ? v : v - size()];
  }
  void copy_to(Point* to) const {
    if (size() <= tuning::few_copied_vertices) {
      for (std::size_t i = 0; i < size(); ++i) to[i] = (*this)[i];
      return;
    }
    to = std::copy(points_ + start_, points_ + end_, to);
    std::copy(points_ + begin_, points_ + start_, to);
  }
  bool operator<(const Rotation& o) const {
    for (std::size_t i = 0; i < std::min(size(), o.size()); ++i)
      if ((*this)[i] != o[i]) return lexicographically_less((*this)[i], o[i]);
    return size() < o.size();
  }

 private:
  const Point* points_;
  std::uint32_t begin_, end_, start_;
};

/// A polygon with its sort key.
struct PolygonKey {
  Point first;        ///< of its outer ring
  std::uint32_t row;  ///< of the result
  std::uint32_t index;
  std::uint32_t outer;  ///< its outer ring
};

Rotation canonical_rotation(const Rings& rings, std::size_t ring) {
  const std::uint32_t begin = rings.begin(ring), end = rings.ends[ring];
  const auto [first, repeated] = smallest_vertex(std::span(rings.points).subspan(begin, end - begin));
  const std::uint32_t best = begin + first;
  Rotation rotation(rings, ring, best);
  if (!repeated) return rotation;
  // Under leonov_nikitin a contour may visit its smallest vertex more than once.
  for (std::uint32_t v = best + 1; v < end; ++v) {
    if (rings.points[v] != rings.points[best]) continue;
    const Rotation other(rings, ring, v);
    if (other < rotation) rotation = other;
  }
  return rotation;
}

/// The same arrays without their elements; the capacity stays.
RegionSet emptied(RegionSet spare) {
  spare.points.clear();
  spare.contour_ends.clear();
  spare.polygon_ends.clear();
  return spare;
}

}  // namespace

RegionSet assemble(const Rings& rings, const Nesting& nesting, RegionSet spare) {
  check_count(rings.points.size(), "vertices of the result", most_vertices);
  Array<Rotation> rotations(rings.size(), Rotation(rings));
  Array<PolygonKey> polygons(nesting.polygon_count);
  for_ranges(rings.size(), tuning::rings_a_task, [&](std::size_t begin, std::size_t end) {
    for (auto r = static_cast<std::uint32_t>(begin); r < end; ++r) {
      rotations[r] = canonical_rotation(rings, r);
      if (nesting.outer[r]) {
        const std::uint32_t polygon = nesting.polygon[r];
        polygons[polygon] = {rotations[r][0], nesting.row.empty() ? 0 : nesting.row[polygon], polygon, r};
      }
    }
  });

  // Polygons by their outer rings; the rings of each together, the outer one first.
  Array<std::uint32_t> ends(nesting.polygon_count), members;
  counting_sort(ends, members, [&](const auto& visit) {
    for (std::uint32_t r = 0; r < rings.size(); ++r) visit(nesting.polygon[r], r);
  });
  parallel_sort(polygons.begin(), polygons.end(), [&](const PolygonKey& p, const PolygonKey& q) {
    if (p.row != q.row) return p.row < q.row;
    return p.first != q.first ? lexicographically_less(p.first, q.first) : rotations[p.outer] < rotations[q.outer];
  });

  RegionSet result = emptied(std::move(spare));
  resize_with_zeros(result.points, rings.points.size());
  result.contour_ends.reserve(rings.size());
  result.polygon_ends.reserve(nesting.polygon_count);
  Array<std::uint32_t> order;  // of the rings in the result
  order.reserve(rings.size());
  std::uint32_t size = 0;
  Steps steps(polygons.size());
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    steps();
    const PolygonKey& polygon = polygons[p];
    if (p + fetched_ahead < polygons.size()) {
      const PolygonKey& later = polygons[p + fetched_ahead];
      fetch_around(ends, later.index);
      fetch(&rotations[later.outer]);
    }
    // ends[p] has moved from the beginning of the polygon's rings to their end.
    const auto first = members.begin() + (polygon.index == 0 ? 0 : ends[polygon.index - 1]);
    const auto last = members.begin() + ends[polygon.index];
    if (last - first > 1)
      parallel_sort(first, last, [&](std::uint32_t r, std::uint32_t s) {
        return nesting.outer[r] != nesting.outer[s] ? nesting.outer[r] != 0 : rotations[r] < rotations[s];
      });
    for (auto r = first; r != last; ++r) {
      order.push_back(*r);
      result.contour_ends.push_back(size += static_cast<std::uint32_t>(rotations[*r].size()));
    }
    result.polygon_ends.push_back(static_cast<std::uint32_t>(result.contour_ends.size()));
  }
  for_ranges(order.size(), tuning::rings_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      rotations[order[i]].copy_to(result.points.data() + (i == 0 ? 0 : result.contour_ends[i - 1]));
  });
  return result;
}

RegionSet join(Array<RegionSet> parts, RegionSet spare, PolygonRows* rows) {
  if (parts.size() == 1 && (!rows || std::is_sorted(rows->of[0].begin(), rows->of[0].end()))) {
    if (rows) rows->joined = std::move(rows->of[0]);
    return std::move(parts[0]);
  }
  struct Polygon {
    Point first;  // no polygon of another part starts there: parts have no point in common
    std::uint32_t part, index;
    std::uint32_t row;
    std::uint32_t point, contour;  // where it begins in the result
  };
  Array<Polygon> polygons;
  std::size_t points = 0, contours = 0;
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    const RegionView view = parts[i];
    points += view.points.size();
    contours += view.contour_ends.size();
    check_count(points, "vertices of the result", most_vertices);
    for (std::uint32_t p = 0; p < view.polygon_count(); ++p)
      polygons.push_back(
          {view.points[view.contour_begin(view.polygon_begin(p))], i, p, rows ? rows->of[i][p] : 0, 0, 0});
  }
  // The polygons of one part are sorted already, even if two start at the same vertex.
  parallel_sort(polygons.begin(), polygons.end(), [](const Polygon& p, const Polygon& q) {
    if (p.row != q.row) return p.row < q.row;
    if (p.first != q.first) return lexicographically_less(p.first, q.first);
    return p.index < q.index;
  });

  if (rows) {
    rows->joined.clear();
    for (const Polygon& polygon : polygons) rows->joined.push_back(polygon.row);
  }
  RegionSet result = emptied(std::move(spare));
  resize_with_zeros(result.points, points);
  result.contour_ends.resize(contours);
  result.polygon_ends.resize(polygons.size());
  std::uint32_t point = 0, contour = 0;
  Steps steps(polygons.size());
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    steps();
    const RegionView view = parts[polygons[i].part];
    const std::uint32_t begin = view.polygon_begin(polygons[i].index), end = view.polygon_end(polygons[i].index);
    polygons[i].point = point;
    polygons[i].contour = contour;
    point += view.contour_ends[end - 1] - view.contour_begin(begin);
    contour += end - begin;
    result.polygon_ends[i] = contour;
  }
  for_ranges(polygons.size(), tuning::joined_polygons_a_task, [&](std::size_t first, std::size_t past) {
    for (std::size_t i = first; i < past; ++i) {
      const RegionView view = parts[polygons[i].part];
      const std::uint32_t begin = view.polygon_begin(polygons[i].index), end = view.polygon_end(polygons[i].index);
      const std::uint32_t first_point = view.contour_begin(begin);
      std::copy(view.points.begin() + first_point, view.points.begin() + view.contour_ends[end - 1],
                result.points.begin() + polygons[i].point);
      for (std::uint32_t c = begin; c < end; ++c)
        result.contour_ends[polygons[i].contour + c - begin] = view.contour_ends[c] - first_point + polygons[i].point;
    }
  });
  return result;
}

}  // namespace oblast::internal
