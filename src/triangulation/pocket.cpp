#include "triangulation/pocket.h"

#include <algorithm>
#include <cassert>

#include "base/call_memory.h"
#include "exact/orientation.h"

namespace oblast::internal::triangulation {
namespace {

constexpr std::uint32_t taken_out = 1;  // Triangle::mark

}  // namespace

void Pocket::begin(std::uint32_t from, std::uint32_t to) {
  from_ = from;
  to_ = to;
  free_.clear();
  right_.clear();
  left_.clear();
}

void Pocket::take(std::uint32_t triangle) {
  free_.push_back(triangle);
  mesh_.triangles[triangle].mark = taken_out;
}

void Pocket::read(const Array<HalfEdge>& half_edges, Border& border) {
  border.clear();
  for (const HalfEdge h : half_edges)
    border.push_back({mesh_.origin(h), mesh_.twin(h), none, mesh_.is_constrained(h) ? 1U : 0U});
  // Triangles taken out need their vertices no more: a half-edge's origin now holds its place in the border.
  for (std::uint32_t i = 0; i < half_edges.size(); ++i)
    mesh_.triangles[triangle_of(half_edges[i])].vertex[side_of(half_edges[i])] = i;
  for (Side& side : border) {
    const Triangle& beyond = mesh_.triangles[triangle_of(side.beyond)];
    if (beyond.mark != taken_out) continue;
    side.partner = beyond.vertex[side_of(side.beyond)];
    side.beyond = none;
  }
}

std::uint32_t Pocket::make_triangle(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  const std::uint32_t t = free_.back();
  free_.pop_back();
  mesh_.triangles[t] = {{x, y, z}, 0, {none, none, none}, 0};
  leaving_[x] = half_edge(t, 0);
  leaving_[y] = half_edge(t, 1);
  leaving_[z] = half_edge(t, 2);
  return t;
}

void Pocket::attach(HalfEdge made, const Side& side, Border& border) {
  mesh_.triangles[triangle_of(made)].constrained |= side.constrained << side_of(made);
  if (side.partner == none) {
    mesh_.join(made, side.beyond);
    return;
  }
  const Side& partner = border[side.partner];
  if (partner.beyond != none)
    mesh_.join(made, partner.beyond);
  else
    border[partner.partner].beyond = made;
}

/// Returns the half-edge along the constraint, from `end` to the first vertex of the border.
HalfEdge Pocket::fill_one(Border& border, std::uint32_t end, Array<HalfEdge>& new_sides) {
  stack_.clear();
  for (std::size_t i = 0; i < border.size(); ++i) {
    Side side = border[i];
    const std::uint32_t z = i + 1 < border.size() ? border[i + 1].origin : end;
    while (!stack_.empty()) {
      const Side before = stack_.back();
      const std::uint32_t x = before.origin, y = side.origin;
      if (exact::orientation(mesh_.points[x], mesh_.points[y], mesh_.points[z]) <= 0) break;
      stack_.pop_back();
      const std::uint32_t t = make_triangle(x, y, z);
      attach(half_edge(t, 0), before, border);
      attach(half_edge(t, 1), side, border);
      side = {x, half_edge(t, 2), none, 0};
      new_sides.push_back(side.beyond);
    }
    stack_.push_back(side);
  }
  assert(stack_.size() == 1);
  new_sides.pop_back();
  return stack_.back().beyond;
}

HalfEdge Pocket::fill(Array<HalfEdge>& new_sides) {
  std::reverse(left_.begin(), left_.end());
  read(right_, right_border_);
  read(left_, left_border_);
  const HalfEdge backward = fill_one(right_border_, to_, new_sides);
  const HalfEdge forward = fill_one(left_border_, from_, new_sides);
  mesh_.join(forward, backward);
  mesh_.set_constrained(forward);
  mesh_.set_constrained(backward);
  return forward;
}

}  // namespace oblast::internal::triangulation
