#include "zones/cell_borders.h"

#include <algorithm>

#include "base/call.h"
#include "zones/distance.h"

namespace oblast::internal::zoning {
namespace {

using triangulation::half_edge;
using triangulation::triangle_of;

/// An edge takes the place of so many at most, which bounds the work.
constexpr std::size_t longest_flattened = 64;

class Walker {
 public:
  Walker(const Diagram& diagram, std::span<const Contact> contacts, double flattening, noding::SourceChanges& changes,
         noding::Strands& strands)
      : diagram_(diagram),
        mesh_(diagram.mesh),
        contacts_(contacts),
        flattening_(flattening),
        changes_(changes),
        strands_(strands) {}

  void run() {
    const auto count = static_cast<std::uint32_t>(mesh_.triangles.size());
    passed_.assign(count, false);
    Steps steps(2 * std::size_t{count});
    for (std::uint32_t t = 0; t < count; ++t) {
      steps();
      if (borders_of(t) != 3) continue;
      for (std::uint32_t i = 0; i < 3; ++i) walk_from(half_edge(t, i));
    }
    for (std::uint32_t t = 0; t < count; ++t) {
      steps();
      if (borders_of(t) == 2 && !passed_[t]) walk_around(t);
    }
  }

 private:
  /// How many sides of the triangle have a border across them. All at infinity are of the far outside: they have none.
  int borders_of(std::uint32_t t) const {
    if (mesh_.triangles[t].is_ghost()) return 0;
    const auto& v = mesh_.triangles[t].vertex;
    const std::uint32_t a = diagram_.object[v[0]], b = diagram_.object[v[1]], c = diagram_.object[v[2]];
    return static_cast<int>(a != b) + static_cast<int>(b != c) + static_cast<int>(c != a);
  }

  void walk_from(HalfEdge out) {
    const HalfEdge first = out;
    begin(diagram_.circle[triangle_of(out)].centre);
    HalfEdge in = mesh_.twin(out);
    for (Steps steps; borders_of(triangle_of(in)) == 2; in = mesh_.twin(out)) {
      steps();
      passed_[triangle_of(in)] = true;
      step_across(in);
      out = other_border(in);
    }
    // Each path is walked from both ends.
    if (in < first) return;
    step_across(in);
    close(mesh_.twin(first), 2);
  }

  void walk_around(std::uint32_t t) {
    HalfEdge first = half_edge(t, 0);
    while (!diagram_.is_border(first)) first = triangulation::next(first);
    begin(diagram_.circle[t].centre);
    HalfEdge in = mesh_.twin(first);
    for (Steps steps; !passed_[t]; in = mesh_.twin(other_border(in))) {
      steps();
      passed_[triangle_of(in)] = true;
      step_across(in);
    }
    if (path_.size() > 1 && path_.back() != path_.front()) add(Point(path_.front()), 0);
    close(mesh_.twin(first), 4);
  }

  HalfEdge other_border(HalfEdge h) const {
    const HalfEdge next = triangulation::next(h);
    return diagram_.is_border(next) ? next : triangulation::next(next);
  }

  void begin(const Point& p) {
    path_.assign(1, p);
    limit_.assign(1, 0);
  }

  /// To the triangle that h is a side of.
  void step_across(HalfEdge h) {
    double limit = 0;
    if (flattening_ > 0)
      limit = std::min(flattening_, distance(mesh_.points[mesh_.origin(h)], mesh_.points[mesh_.target(h)]) / 8);
    limit_.back() = std::min(limit_.back(), limit);
    if (const std::uint32_t contact = diagram_.contact_across(h); contact != none) add(contacts_[contact].at, 0);
    add(diagram_.circle[triangle_of(h)].centre, limit);
  }

  void add(const Point& p, double limit) {
    if (path_.back() == p) {
      limit_.back() = std::min(limit_.back(), limit);
    } else {
      path_.push_back(p);
      limit_.push_back(limit);
    }
  }

  /// Leaves vertices out. From each that stays, the edge goes as far as it can.
  void flatten() {
    std::size_t kept = 1;
    const std::size_t last = path_.size() - 1;
    for (std::size_t from = 0; from < last;) {
      std::size_t to = from + 1;
      while (to < last && to - from < longest_flattened && is_near(from, to + 1)) ++to;
      // What is left out may have been all that lies between a vertex and itself.
      if (path_[to] != path_[kept - 1]) path_[kept++] = path_[to];
      from = to;
    }
    path_.resize(kept);
  }

  /// Whether all vertices between two are as near to the edge between these as their limits say.
  bool is_near(std::size_t from, std::size_t to) const {
    for (std::size_t i = from + 1; i < to; ++i)
      if (!(distance_from_segment(path_[i], path_[from], path_[to]) <= limit_[i]) || limit_[i] == 0) return false;
    return true;
  }

  /// The path crosses `side` first, from its right to its left. A path of fewer vertices than `least` encloses nothing.
  void close(HalfEdge side, std::size_t least) {
    if (path_.size() < least) return;
    if (flattening_ > 0 && path_.size() > least) flatten();
    if (path_.size() < 2) return;
    const std::uint32_t left = diagram_.object[mesh_.origin(side)], right = diagram_.object[mesh_.target(side)];
    strands_.points.insert(strands_.points.end(), path_.begin(), path_.end());
    strands_.close_strand({0, change(left, right)}, noding::any_group);
  }

  std::int32_t change(std::uint32_t left, std::uint32_t right) {
    if (right == none) return static_cast<std::int32_t>(left) + 1;
    if (left == none) return -(static_cast<std::int32_t>(right) + 1);
    return changes_.add_pair(left, right);
  }

  const Diagram& diagram_;
  const Mesh& mesh_;
  std::span<const Contact> contacts_;
  double flattening_;
  noding::SourceChanges& changes_;
  noding::Strands& strands_;
  Array<Point> path_;
  Array<double> limit_;  ///< by vertex of the path: how far it may be from the border if it is left out
  Array<bool> passed_;   ///< by triangle
};

}  // namespace

void append_cell_borders(const Diagram& diagram, std::span<const Contact> contacts, double flattening,
                         noding::SourceChanges& changes, noding::Strands& strands) {
  Walker(diagram, contacts, flattening, changes, strands).run();
}

}  // namespace oblast::internal::zoning
