#include "zones/piece_check.h"

#include <algorithm>
#include <cmath>

#include "base/call.h"
#include "zones/distance.h"

namespace oblast::internal::zoning {

int PieceCheck::halvings(std::uint32_t first, std::uint32_t last, std::uint32_t object) {
  const Mesh& mesh = diagram_.mesh;
  a_ = mesh.points[first];
  b_ = mesh.points[last];
  object_ = object;
  const double length = distance(a_, b_);
  if (length <= 2 * room_.sampling) {
    // Each of its places is as near to one of its ends.
    error_ = std::max(error_, length / 2);
    narrow_ = true;
    return 0;
  }
  depth_ = radius_ = 0;
  relaxed_.clear();
  narrow_ = diagram_.object[first] != object || diagram_.object[last] != object;
  begin_flood();
  HalfEdge h = ends_.leaving[first];
  do {
    reach(triangulation::triangle_of(h));
    h = mesh.clockwise(h);
  } while (h != ends_.leaving[first]);
  Steps steps;
  // Once the piece is known to be too long, a few more circles tell about how much.
  for (std::size_t looked = 0; !waiting_.empty() && (radius_ == 0 || looked < 64); ++looked) {
    steps();
    const std::uint32_t t = waiting_.back();
    waiting_.pop_back();
    look_at(t);
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t across = triangulation::triangle_of(mesh.triangles[t].twin[i]);
      if (mesh.triangles[across].is_ghost()) continue;
      const Point& centre = diagram_.centre[across];
      const double radius = distance(centre, mesh.points[mesh.triangles[across].vertex[0]]);
      if (distance_from_segment(centre, a_, b_) < radius + margin_) reach(across);
    }
  }
  if (radius_ == 0) {
    error_ = std::max(error_, depth_);
    for (const Relaxed& relaxed : relaxed_) error_ = std::max(error_, relaxed.needed());
    return 0;
  }
  // A chord of this length cuts a circle of this radius as deep as the tolerance. Circles become smaller as sites come
  // in, so this divides too little rather than too much.
  const double wanted = std::sqrt(8 * radius_ * room_.sampling);
  return std::clamp(length > wanted ? std::ilogb(length / wanted) : 1, 1, 6);
}

void PieceCheck::begin_flood() {
  for (const std::uint32_t t : reached_) slots_[t] = none;
  reached_.clear();
  waiting_.clear();
}

void PieceCheck::reach(std::uint32_t triangle) {
  if (diagram_.mesh.triangles[triangle].is_ghost()) return;
  if (2 * (reached_.size() + 1) > slots_.size()) {
    Array<std::uint32_t> all;
    for (const std::uint32_t slot : reached_) all.push_back(slots_[slot]);
    slots_.assign(std::max<std::size_t>(64, 4 * slots_.size()), none);
    reached_.clear();
    for (const std::uint32_t t : all) {
      std::size_t slot = t * 0x9e3779b9U & (slots_.size() - 1);
      while (slots_[slot] != none) slot = (slot + 1) & (slots_.size() - 1);
      slots_[slot] = t;
      reached_.push_back(static_cast<std::uint32_t>(slot));
    }
  }
  std::size_t slot = triangle * 0x9e3779b9U & (slots_.size() - 1);
  for (; slots_[slot] != none; slot = (slot + 1) & (slots_.size() - 1))
    if (slots_[slot] == triangle) return;
  slots_[slot] = triangle;
  reached_.push_back(static_cast<std::uint32_t>(slot));
  waiting_.push_back(triangle);
}

void PieceCheck::look_at(std::uint32_t triangle) {
  const Mesh& mesh = diagram_.mesh;
  const auto& vertex = mesh.triangles[triangle].vertex;
  const auto foreign = [&](std::uint32_t v) { return diagram_.object[v] != object_; };
  if (!foreign(vertex[0]) && !foreign(vertex[1]) && !foreign(vertex[2])) return;
  const Point& centre = diagram_.centre[triangle];
  const double radius = distance(centre, mesh.points[vertex[0]]);
  judge(centre, radius, vertex);
  narrow_ |= distance_from_segment(centre, a_, b_) <= room_.flattening + margin_;
  for (const std::uint32_t v : vertex)
    narrow_ |= foreign(v) && distance_from_segment(mesh.points[v], a_, b_) <= room_.tolerance + margin_;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdge side = triangulation::half_edge(triangle, i);
    if (mesh.triangles[triangulation::triangle_of(mesh.twin(side))].is_ghost()) continue;
    if (foreign(mesh.origin(side)) || foreign(mesh.target(side))) look_at_crossing(side);
  }
}

/// Where the border between the cells at both ends of the side crosses the piece.
void PieceCheck::look_at_crossing(HalfEdge side) {
  const Mesh& mesh = diagram_.mesh;
  const Point &p = diagram_.centre[triangulation::triangle_of(side)],
              &q = diagram_.centre[triangulation::triangle_of(mesh.twin(side))];
  const double x = b_.x - a_.x, y = b_.y - a_.y;
  const double of_p = x * (p.y - a_.y) - y * (p.x - a_.x), of_q = x * (q.y - a_.y) - y * (q.x - a_.x);
  if ((of_p > 0) == (of_q > 0)) return;
  const double along = of_p / (of_p - of_q);
  const Point at{p.x + along * (q.x - p.x), p.y + along * (q.y - p.y)};
  const double radius = distance(at, mesh.points[mesh.origin(side)]);
  if (distance_from_segment(at, a_, b_) <= margin_) narrow_ = true;
  const std::uint32_t sites[] = {mesh.origin(side), mesh.target(side)};
  judge(at, radius, sites);
}

/// `sites`: some to which the place belongs, all at the distance `radius`.
void PieceCheck::judge(const Point& at, double radius, std::span<const std::uint32_t> sites) {
  const double apart = distance_from_segment(at, a_, b_), depth = radius - apart;
  if (depth <= room_.sampling) {
    depth_ = std::max(depth_, depth);
    return;
  }
  for (const std::uint32_t site : sites)
    if (diagram_.object[site] != object_) relax(at, apart, radius, site);
}

void PieceCheck::relax(const Point& at, double apart, double radius, std::uint32_t site) {
  auto relaxed = std::find_if(relaxed_.begin(), relaxed_.end(), [&](const Relaxed& r) { return r.site == site; });
  if (relaxed == relaxed_.end()) relaxed = relaxed_.insert(relaxed_.end(), {site, {0, 0, 0}});
  const Mesh& mesh = diagram_.mesh;
  const auto keep = [&](int i, double from_object) {
    relaxed->difference[i] = std::max(relaxed->difference[i], from_object - apart);
  };
  Point end[2];
  for (const int i : {0, 1}) {
    end[i] = mesh.points[site];
    if (const std::uint32_t piece = ends_.at_vertex[site][i]; piece != none) {
      const auto [first, last] = ends_.of_piece[piece];
      end[i] = mesh.points[first == site ? last : first];
    }
    keep(i, distance_from_segment(at, mesh.points[site], end[i]));
  }
  const bool straight_on = distance_from_segment(mesh.points[site], end[0], end[1]) <= margin_;
  keep(2, straight_on ? distance_from_segment(at, end[0], end[1]) : radius);
  if (relaxed->needed() > room_.sampling) radius_ = std::max(radius_, radius);
}

}  // namespace oblast::internal::zoning
