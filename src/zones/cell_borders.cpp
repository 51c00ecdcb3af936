#include "zones/cell_borders.h"

#include "base/call.h"

namespace oblast::internal::zoning {
namespace {

using triangulation::half_edge;
using triangulation::triangle_of;

class Walker {
 public:
  Walker(const Diagram& diagram, std::span<const Contact> contacts, noding::SourceChanges& changes,
         noding::Strands& strands)
      : diagram_(diagram), mesh_(diagram.mesh), contacts_(contacts), changes_(changes), strands_(strands) {}

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
    path_.assign(1, diagram_.centre[triangle_of(out)]);
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
    path_.assign(1, diagram_.centre[t]);
    HalfEdge in = mesh_.twin(first);
    for (Steps steps; !passed_[t]; in = mesh_.twin(other_border(in))) {
      steps();
      passed_[triangle_of(in)] = true;
      step_across(in);
    }
    if (path_.size() > 1 && path_.back() != path_.front()) path_.push_back(Point(path_.front()));
    close(mesh_.twin(first), 4);
  }

  HalfEdge other_border(HalfEdge h) const {
    const HalfEdge next = triangulation::next(h);
    return diagram_.is_border(next) ? next : triangulation::next(next);
  }

  /// To the triangle that h is a side of.
  void step_across(HalfEdge h) {
    if (const std::uint32_t contact = diagram_.contact_across(h); contact != none) add(contacts_[contact].at);
    add(diagram_.centre[triangle_of(h)]);
  }

  void add(const Point& p) {
    if (path_.back() != p) path_.push_back(p);
  }

  /// The path crosses `side` first, from its right to its left. A path of fewer vertices than `least` encloses nothing.
  void close(HalfEdge side, std::size_t least) {
    if (path_.size() < least) return;
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
  noding::SourceChanges& changes_;
  noding::Strands& strands_;
  Array<Point> path_;
  Array<bool> passed_;  ///< by triangle
};

}  // namespace

void append_cell_borders(const Diagram& diagram, std::span<const Contact> contacts, noding::SourceChanges& changes,
                         noding::Strands& strands) {
  Walker(diagram, contacts, changes, strands).run();
}

}  // namespace oblast::internal::zoning
