#include "locate/slab_tree.h"

#include <algorithm>

#include "base/call.h"
#include "base/counting_sort.h"
#include "base/memory_budget.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "exact/orientation.h"

namespace oblast::internal::locate {
namespace {

using exact::orientation;

bool by_y(const Point& p, const Point& q) { return p.y < q.y || (p.y == q.y && p.x < q.x); }

/// Whether the first is left of the other (-1), right of it (1) or neither, where both begin and where both end.
struct Sides {
  int low, high;
};
Sides sides_of(const Edges& edges, Index e, Index f) {
  const Point &e0 = edges.lower(e), &e1 = edges.upper(e), &f0 = edges.lower(f), &f1 = edges.upper(f);
  return {e0.y >= f0.y ? -orientation(f0, f1, e0) : orientation(e0, e1, f0),
          e1.y <= f1.y ? -orientation(f0, f1, e1) : orientation(e0, e1, f1)};
}

}  // namespace

SlabTree::SlabTree(const Edges& edges) : edges_(edges) {
  list_vertices();
  list_level_edges();
  if (ys_.size() < 2) return;
  list_nodes();
  is_ordered_.assign(ends_.size(), 1);
  for_ranges(ends_.size(), tuning::strands_a_task, [&](std::size_t node, std::size_t end) {
    for (; node < end; ++node) sort_node(node);
  });
}

void SlabTree::list_vertices() {
  vertices_.reserve(edges_.edges.size());
  for (const Index e : edges_.edges) vertices_.push_back(edges_.from(e));
  parallel_sort(vertices_.begin(), vertices_.end(), by_y);
  vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    if (v > 0 && vertices_[v].y == vertices_[v - 1].y) continue;
    ys_.push_back(vertices_[v].y);
    first_at_.push_back(v);
  }
  first_at_.push_back(vertices_.size());
}

void SlabTree::list_level_edges() {
  for (const Index e : edges_.edges) {
    const Point &p = edges_.from(e), &q = edges_.to(e);
    if (p.y == q.y) levels_.push_back({p.y, std::min(p.x, q.x), std::max(p.x, q.x)});
  }
  parallel_sort(levels_.begin(), levels_.end(),
                [](const Segment& s, const Segment& t) { return s.y < t.y || (s.y == t.y && s.x0 < t.x0); });
  std::size_t kept = 0;
  for (const Segment& s : levels_) {
    if (kept > 0 && levels_[kept - 1].y == s.y && s.x0 <= levels_[kept - 1].x1)
      levels_[kept - 1].x1 = std::max(levels_[kept - 1].x1, s.x1);
    else
      levels_[kept++] = s;
  }
  levels_.resize(kept);
}

/// The last y at or below. REQUIRES: ys_[0] <= y.
std::size_t SlabTree::slab_of(double y) const {
  return static_cast<std::size_t>(std::upper_bound(ys_.begin(), ys_.end(), y) - ys_.begin()) - 1;
}

/// Node i has the halves 2 i and 2 i + 1; slab s is node s + the number of slabs.
template <class Visit>
void SlabTree::for_each_node(Index edge, const Visit& visit) const {
  const std::size_t slabs = ys_.size() - 1;
  std::size_t first = slab_of(edges_.lower(edge).y) + slabs, past = slab_of(edges_.upper(edge).y) + slabs;
  for (; first < past; first /= 2, past /= 2) {
    if (first % 2 == 1) visit(first++);
    if (past % 2 == 1) visit(--past);
  }
}

void SlabTree::list_nodes() {
  Steps steps(2 * edges_.edges.size());
  const auto for_each_entry = [&](const auto& visit) {
    for (const Index e : edges_.edges) {
      steps();
      for_each_node(e, [&](std::size_t node) { visit(node, e); });
    }
  };
  ends_.resize(2 * (ys_.size() - 1) + 1);  // the last one has no node: it ends where all lists do
  count_begins(ends_, for_each_entry);
  const Charge charge(ends_.back() * sizeof(Index));
  lists_.resize(ends_.back());
  put_in_places(ends_, for_each_entry, [&](std::size_t slot, Index e) { lists_[slot] = e; });
}

void SlabTree::sort_node(std::size_t node) {
  const auto begin = lists_.begin() + static_cast<std::ptrdiff_t>(node == 0 ? 0 : ends_[node - 1]);
  const auto end = lists_.begin() + static_cast<std::ptrdiff_t>(ends_[node]);
  // Where edges cross this is no order; std::stable_sort then gives some sequence, and reads nothing else.
  std::stable_sort(begin, end, [&](Index e, Index f) {
    const Sides sides = sides_of(edges_, e, f);
    return sides.low != 0 ? sides.low < 0 : sides.high < 0;
  });
  const bool is_ordered = std::adjacent_find(begin, end, [&](Index e, Index f) {
                            const Sides sides = sides_of(edges_, e, f);
                            return sides.low > 0 || sides.high > 0;
                          }) == end;
  is_ordered_[node] = is_ordered ? 1 : 0;
}

/// REQUIRES: ys_[y] == p.y.
bool SlabTree::is_at_vertex_or_level(const Point& p, std::size_t y) const {
  const auto first = vertices_.begin() + static_cast<std::ptrdiff_t>(first_at_[y]);
  const auto end = vertices_.begin() + static_cast<std::ptrdiff_t>(first_at_[y + 1]);
  if (std::binary_search(first, end, p, by_y)) return true;
  const auto after = std::partition_point(levels_.begin(), levels_.end(),
                                          [&](const Segment& s) { return s.y < p.y || (s.y == p.y && s.x0 <= p.x); });
  return after != levels_.begin() && after[-1].y == p.y && p.x <= after[-1].x1;
}

Location SlabTree::locate(const Point& p) const {
  if (ys_.empty() || !(p.y >= ys_.front()) || p.y > ys_.back()) return Location::outside;
  const std::size_t slab = slab_of(p.y), slabs = ys_.size() - 1;
  if (ys_[slab] == p.y && is_at_vertex_or_level(p, slab)) return Location::boundary;
  if (slab == slabs) return Location::outside;
  std::size_t left = 0;
  for (std::size_t node = slab + slabs; node > 0; node /= 2) {
    const auto begin = lists_.begin() + static_cast<std::ptrdiff_t>(ends_[node - 1]);
    const auto end = lists_.begin() + static_cast<std::ptrdiff_t>(ends_[node]);
    bool is_on = false;
    const auto is_left = [&](Index e) {
      const int side = orientation(edges_.lower(e), edges_.upper(e), p);
      is_on = is_on || side == 0;
      return side < 0;
    };
    // An edge with the point on it is come by: it is the first that is not left.
    left += static_cast<std::size_t>(is_ordered_[node] != 0 ? std::partition_point(begin, end, is_left) - begin
                                                            : std::count_if(begin, end, is_left));
    if (is_on) return Location::boundary;
  }
  return left % 2 == 1 ? Location::inside : Location::outside;
}

}  // namespace oblast::internal::locate
