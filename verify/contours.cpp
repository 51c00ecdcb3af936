// The checks of single contours: their form, whether they are simple, and which are outer contours.
#include "verify/contours.h"

#include <oblast/domain.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "verify/predicates.h"

namespace oblast::verify {
namespace {

// A ray at a vertex through which a walk passes, towards the vertex before or after it.
struct Ray {
  std::uint32_t pass;
  bool out;
  Point towards;
};

// All `passes` go through one vertex. The next ray after `out`, counter-clockwise, must be the ray of the same pass
// back to the vertex from which it came. Between the two lies the sector of the interior that the walk follows.
//
//            in \   interior   / out
//                \   sector   /           no other ray between out and in
//                 \          /
//                  * -------- other rays
std::optional<Fault> check_hugs(const Edges& edges, std::span<const std::uint32_t> passes,
                                const std::vector<std::uint32_t>& previous) {
  const Point at = edges.from(passes.front());
  std::vector<Ray> rays;
  for (const std::uint32_t v : passes) {
    rays.push_back({v, true, edges.to(v)});
    rays.push_back({v, false, edges.from(previous[v])});
  }
  std::sort(rays.begin(), rays.end(), [&](const Ray& r, const Ray& s) { return angle_less(at, r.towards, s.towards); });
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Ray& after = rays[(i + 1) % rays.size()];
    if (rays[i].out && (after.out || after.pass != rays[i].pass)) {
      return edges.fault_at(rays[i].pass,
                            "the walk through " + to_text(at) + " does not hug one sector of the interior");
    }
  }
  return std::nullopt;
}

std::optional<Fault> check_passes(const Edges& edges, std::span<const std::uint32_t> passes,
                                  const std::vector<std::uint32_t>& previous, ContourConvention convention) {
  if (convention == ContourConvention::leonov_nikitin) return check_hugs(edges, passes, previous);
  for (std::size_t i = 1; i < passes.size(); ++i) {
    if (edges.contour_of[passes[i - 1]] == edges.contour_of[passes[i]]) {
      return edges.fault_at(passes[i], "the contour visits " + to_text(edges.from(passes[i])) + " twice");
    }
  }
  return std::nullopt;
}

// True if the outside of the contour is to the west of its smallest vertex: the lowest edge there runs away from it.
bool is_outer(const Edges& edges, std::uint32_t contour) {
  const std::uint32_t begin = edges.regions.contour_begin(contour), end = edges.regions.contour_end(contour);
  Point at = edges.from(begin);
  for (std::uint32_t v = begin; v < end; ++v) {
    if (lexicographically_less(edges.from(v), at)) at = edges.from(v);
  }
  const Point* lowest = nullptr;
  bool lowest_out = false;
  const auto offer = [&](const Point& towards, bool out) {
    if (lowest != nullptr && side_of_line(at, *lowest, towards) > 0) return;
    lowest = &towards;
    lowest_out = out;
  };
  for (std::uint32_t v = begin; v < end; ++v) {
    if (edges.from(v) == at) offer(edges.to(v), true);
    if (edges.to(v) == at) offer(edges.from(v), false);
  }
  return lowest_out;
}

std::optional<Fault> check_ends(std::span<const std::uint32_t> ends, std::uint32_t first, std::size_t total,
                                const std::string& what) {
  std::uint32_t before = first;
  for (const std::uint32_t end : ends) {
    if (end <= before) return Fault{what + " are not increasing: an empty entry, or a step back", {}};
    before = end;
  }
  if (before != first + total) return Fault{what + " do not end at the end of their array", {}};
  return std::nullopt;
}

}  // namespace

std::optional<Fault> check_offsets(const RegionView& regions) {
  if (auto fault = check_ends(regions.contour_ends, regions.first_point, regions.points.size(), "contour_ends"))
    return fault;
  if (regions.polygon_ends.empty()) return std::nullopt;
  return check_ends(regions.polygon_ends, regions.first_contour, regions.contour_count(), "polygon_ends");
}

std::optional<Fault> check_vertices(const Edges& edges) {
  for (std::uint32_t v = 0; v < edges.size(); ++v) {
    const Point p = edges.from(v);
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) return edges.fault_at(v, "a coordinate is not finite");
    if (!in_domain(p.x) || !in_domain(p.y)) return edges.fault_at(v, to_text(p) + " lies outside the domain");
  }
  for (std::uint32_t c = 0; c < edges.regions.contour_count(); ++c) {
    const std::uint32_t begin = edges.regions.contour_begin(c);
    if (edges.regions.contour(c).size() < 3) {
      return edges.fault_at(begin, "the contour at " + to_text(edges.from(begin)) + " has fewer than three vertices");
    }
  }
  for (std::uint32_t v = 0; v < edges.size(); ++v) {
    if (edges.from(v) == edges.to(v)) return edges.fault_at(v, "vertex " + to_text(edges.from(v)) + " is repeated");
  }
  return std::nullopt;
}

std::optional<Fault> check_walks(const Edges& edges, ContourConvention convention) {
  std::vector<std::uint32_t> order(edges.size()), previous(edges.size());
  std::iota(order.begin(), order.end(), 0u);
  for (std::uint32_t v = 0; v < edges.size(); ++v) previous[edges.next[v]] = v;
  std::sort(order.begin(), order.end(), [&](std::uint32_t v, std::uint32_t w) {
    if (edges.from(v) != edges.from(w)) return lexicographically_less(edges.from(v), edges.from(w));
    return v < w;  // passes of one contour are then consecutive
  });
  for (std::size_t first = 0; first < order.size();) {
    std::size_t last = first + 1;
    while (last < order.size() && edges.from(order[last]) == edges.from(order[first])) ++last;
    if (last - first > 1) {
      const std::span passes(order.data() + first, last - first);
      if (auto fault = check_passes(edges, passes, previous, convention)) return fault;
    }
    first = last;
  }
  return std::nullopt;
}

std::optional<Fault> check_roles(const Edges& edges) {
  for (std::uint32_t p = 0; p < edges.regions.polygon_count(); ++p) {
    const std::uint32_t first = edges.regions.polygon_begin(p);
    for (std::uint32_t c = first; c < edges.regions.polygon_end(p); ++c) {
      if (is_outer(edges, c) == (c == first)) continue;
      const std::uint32_t begin = edges.regions.contour_begin(c);
      return edges.fault_at(begin, c == first ? "the first contour of the polygon is not its outer one"
                                              : "a contour after the first is not a hole");
    }
  }
  return std::nullopt;
}

}  // namespace oblast::verify
