// Neighbours and vertices of the Voronoi diagram of points, by CGAL's Delaunay triangulation with exact predicates and
// by exact rational circumcentres. Arguments: SHAPES NEIGHBOURS; neighbours.h has the form of the file.
#include <CGAL/Cartesian_converter.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <optional>

#include "zones/oracles/frame.h"

namespace {

using zones::FrameBox;
using Xy = buffers::Xy;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Number = CGAL::Exact_rational;
using Exact = CGAL::Simple_cartesian<Number>;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<Xy, Kernel>;  // the circumcentre, correctly rounded
using Triangulation =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;
using Face = Triangulation::Face_handle;

/// The nearest double; of two, the one whose last bit is 0.
double rounded(const Number& value) {
  auto [low, high] = CGAL::to_interval(value);
  while (std::nextafter(low, high) < high) {
    const double middle = low + (high - low) / 2;
    (Number(middle) <= value ? low : high) = middle;
  }
  const Number below = value - Number(low), above = Number(high) - value;
  if (below != above) return below < above ? low : high;
  return (std::bit_cast<std::uint64_t>(low) & 1) == 0 ? low : high;
}

class Diagram {
 public:
  Diagram(const buffers::Shapes& shapes) : frame_(shapes) {
    std::vector<std::pair<Kernel::Point_2, std::uint32_t>> points;
    for (const Xy& p : shapes.points) points.emplace_back(Kernel::Point_2(p.x, p.y), points.size());
    triangulation_.insert(points.begin(), points.end());
    if (triangulation_.number_of_vertices() != points.size()) throw std::runtime_error("points are equal");
  }

  void find() {
    for (const Face face : triangulation_.finite_face_handles()) {
      const Exact::Point_2 centre = exact_centre(face);
      const Xy p = face->info() = {rounded(centre.x()) + 0.0, rounded(centre.y()) + 0.0};
      if (frame_.has_inside(p.x, p.y)) vertices.push_back(p);
    }
    const auto less = [](const Xy& p, const Xy& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; };
    std::sort(vertices.begin(), vertices.end(), less);
    const auto equal = [](const Xy& p, const Xy& q) { return p.x == q.x && p.y == q.y; };
    vertices.erase(std::unique(vertices.begin(), vertices.end(), equal), vertices.end());
    for (const auto& edge : triangulation_.finite_edges()) add(edge);
    std::sort(pairs.begin(), pairs.end());
  }

  struct Pair {
    std::uint32_t i, j;
    double length;
    friend auto operator<=>(const Pair&, const Pair&) = default;
  };
  std::vector<Pair> pairs;
  std::vector<Xy> vertices;

 private:
  using Edge = Triangulation::Edge;

  Exact::Point_2 exact_centre(Face face) const {
    const CGAL::Cartesian_converter<Kernel, Exact> exact;
    return CGAL::circumcenter(exact(face->vertex(0)->point()), exact(face->vertex(1)->point()),
                              exact(face->vertex(2)->point()));
  }

  /// The border between the two ends of an edge, if it has a length within the frame.
  void add(const Edge& edge) {
    const Edge mirror = triangulation_.dimension() == 2 ? triangulation_.mirror_edge(edge) : edge;
    const auto a = edge.first->vertex(triangulation_.ccw(edge.second)),
               b = edge.first->vertex(triangulation_.cw(edge.second));
    const bool has_two = triangulation_.dimension() == 2 && !triangulation_.is_infinite(edge.first) &&
                         !triangulation_.is_infinite(mirror.first);
    // Four points of one circle: the border is a place.
    if (has_two && triangulation_.side_of_oriented_circle(edge.first, mirror.first->vertex(mirror.second)->point()) ==
                       CGAL::ON_ORIENTED_BOUNDARY)
      return;
    double length;
    const auto is_inside = [&](Face f) { return frame_.has_inside(f->info().x, f->info().y); };
    if (has_two && is_inside(edge.first) && is_inside(mirror.first)) {
      const Xy p = edge.first->info(), q = mirror.first->info();
      length = std::hypot(p.x - q.x, p.y - q.y);
    } else {
      length = length_in_frame(edge, mirror, a->point(), b->point());
      if (!(length >= 0)) return;
    }
    pairs.push_back({std::min(a->info(), b->info()), std::max(a->info(), b->info()), length});
  }

  /// Of the part of a border that is in the frame, exactly; below 0 if that has no length. The border is a part of the
  /// line m + t (-dy, dx) through the middle m of its two points; it ends at the centres of their triangles.
  double length_in_frame(const Edge& edge, const Edge& mirror, const Kernel::Point_2& a, const Kernel::Point_2& b) {
    const CGAL::Cartesian_converter<Kernel, Exact> exact;
    const Exact::Point_2 p = exact(a), q = exact(b), m = CGAL::midpoint(p, q);
    const Number ux = p.y() - q.y(), uy = q.x() - p.x();
    std::optional<Number> low, high;
    const auto at_least = [&](const Number& t) { low = low ? std::max(*low, t) : t; };
    const auto at_most = [&](const Number& t) { high = high ? std::min(*high, t) : t; };
    // a is counter-clockwise of the third vertex, so the triangle of `edge` is on the right of the way from b to a, and
    // on the left of that from a to b, where t grows.
    const auto end_at = [&](Face face, const auto& limit) {
      if (triangulation_.dimension() < 2 || triangulation_.is_infinite(face)) return;
      const Exact::Vector_2 to = exact_centre(face) - m;
      limit(ux != 0 ? Number(to.x() / ux) : Number(to.y() / uy));
    };
    end_at(edge.first, at_most);
    end_at(mirror.first, at_least);
    const auto clip = [&](const Number& from, const Number& direction, double least, double most) {
      if (direction == 0) return Number(least) < from && from < Number(most);
      const Number t = (Number(least) - from) / direction, s = (Number(most) - from) / direction;
      at_least(std::min(t, s));
      at_most(std::max(t, s));
      return true;
    };
    if (!clip(m.x(), ux, frame_.x0, frame_.x1) || !clip(m.y(), uy, frame_.y0, frame_.y1) || *low >= *high) return -1;
    const double share = CGAL::to_double(*high - *low);
    return share * std::hypot(CGAL::to_double(ux), CGAL::to_double(uy));
  }

  FrameBox frame_;
  Triangulation triangulation_;
};

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 3) throw std::runtime_error("usage: SHAPES NEIGHBOURS");
    Diagram diagram(buffers::read_shapes(argv[1]));
    diagram.find();
    std::vector<std::uint32_t> ends;
    std::vector<double> lengths;
    for (const auto& pair : diagram.pairs) {
      ends.insert(ends.end(), {pair.i, pair.j});
      lengths.push_back(pair.length);
    }
    std::ofstream out(argv[2], std::ios::binary);
    buffers::transfer(out, std::vector<std::uint64_t>{diagram.pairs.size(), diagram.vertices.size()});
    buffers::transfer(out, ends);
    buffers::transfer(out, lengths);
    buffers::transfer(out, diagram.vertices);
    if (!out) throw std::runtime_error(std::string(argv[2]) + ": cannot be written");
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
}
