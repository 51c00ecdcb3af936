#include "zones/piece_check.h"

#include <algorithm>
#include <cmath>

#include "base/call.h"

namespace oblast::internal::zoning {

using triangulation::next;
using triangulation::previous;
using triangulation::triangle_of;

std::uint32_t PieceCheck::parts(const PieceEnds::Ends& piece) {
  const auto [first, last, object] = piece;
  a_ = diagram_.mesh.points[first];
  b_ = diagram_.mesh.points[last];
  object_ = object;
  length_ = distance(a_, b_);
  begin_flood();
  if (length_ <= 2 * room_.sampling) {
    // Each of its places is as near to one of its ends.
    error_ = length_ / 2;
    narrow_ = true;
    return 1;
  }
  along_x_ = (b_.x - a_.x) / length_;
  along_y_ = (b_.y - a_.y) / length_;
  narrow_ = diagram_.object[first] != object || diagram_.object[last] != object;
  flood(first);
  if (radius_ == 0) {
    error_ = depth_;
    for (const Relaxed& relaxed : relaxed_) error_ = std::max(error_, relaxed.needed());
    return 1;
  }
  // A chord of this length cuts a circle of this radius as deep as the tolerance. Circles become smaller as sites come
  // in, so few pieces are divided too often.
  const double wanted = std::sqrt(8 * radius_ * room_.sampling);
  return 1U << std::clamp(length_ > wanted ? std::ilogb(length_ / wanted) + 1 : 1, 1, 6);
}

void PieceCheck::begin_flood() {
  depth_ = radius_ = 0;
  relaxed_.clear();
  waiting_.clear();
  triangles_.clear();
  for (const std::uint32_t t : taken_) slots_[t] = none;
  taken_.clear();
}

void PieceCheck::flood(std::uint32_t first) {
  const Mesh& mesh = diagram_.mesh;
  const HalfEdge begin = diagram_.leaving[first];
  HalfEdge h = begin;
  do {
    if (!mesh.triangles[triangle_of(h)].is_ghost()) reach(triangle_of(h));
    h = mesh.clockwise(h);
  } while (h != begin);
  do {
    if (!mesh.triangles[triangle_of(h)].is_ghost()) {
      look_at(triangle_of(h));
      waiting_.push_back(next(h));
    }
    h = mesh.clockwise(h);
  } while (h != begin);
  Steps steps;
  // Once the piece is known to be too long, a few more circles tell about how much.
  for (std::size_t looked = 0; !waiting_.empty() && (radius_ == 0 || looked < 64); ++looked) {
    steps();
    const HalfEdge entered = mesh.twin(waiting_.back());
    waiting_.pop_back();
    const std::uint32_t t = triangle_of(entered);
    if (mesh.triangles[t].is_ghost()) continue;
    const Circle& circle = diagram_.circle[t];
    if (!(apart(circle.centre) < circle.radius + margin_) || !reach(t)) continue;
    look_at(t);
    waiting_.push_back(next(entered));
    waiting_.push_back(previous(entered));
  }
}

/// False if it was reached before.
bool PieceCheck::reach(std::uint32_t triangle) {
  if (2 * (taken_.size() + 1) > slots_.size()) grow_slots();
  std::size_t slot = triangle * 0x9e3779b9U & (slots_.size() - 1);
  for (; slots_[slot] != none; slot = (slot + 1) & (slots_.size() - 1))
    if (slots_[slot] == triangle) return false;
  slots_[slot] = triangle;
  taken_.push_back(static_cast<std::uint32_t>(slot));
  triangles_.push_back(triangle);
  return true;
}

void PieceCheck::grow_slots() {
  slots_.assign(std::max<std::size_t>(64, 4 * slots_.size()), none);
  taken_.clear();
  for (const std::uint32_t t : triangles_) {
    std::size_t slot = t * 0x9e3779b9U & (slots_.size() - 1);
    while (slots_[slot] != none) slot = (slot + 1) & (slots_.size() - 1);
    slots_[slot] = t;
    taken_.push_back(static_cast<std::uint32_t>(slot));
  }
}

void PieceCheck::look_at(std::uint32_t triangle) {
  const Mesh& mesh = diagram_.mesh;
  const auto& vertex = mesh.triangles[triangle].vertex;
  const auto foreign = [&](std::uint32_t v) { return diagram_.object[v] != object_; };
  if (!foreign(vertex[0]) && !foreign(vertex[1]) && !foreign(vertex[2])) return;
  const auto& [centre, radius] = diagram_.circle[triangle];
  judge(centre, radius, vertex);
  if (!narrow_) {
    narrow_ = apart(centre) <= room_.flattening + margin_;
    for (const std::uint32_t v : vertex) narrow_ |= foreign(v) && apart(mesh.points[v]) <= room_.tolerance + margin_;
  }
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdge side = triangulation::half_edge(triangle, i);
    if (mesh.triangles[triangle_of(mesh.twin(side))].is_ghost()) continue;
    if (foreign(mesh.origin(side)) || foreign(mesh.target(side))) look_at_crossing(side);
  }
}

/// Where the border between the cells at both ends of the side crosses the piece.
void PieceCheck::look_at_crossing(HalfEdge side) {
  const Mesh& mesh = diagram_.mesh;
  const Point &p = diagram_.circle[triangulation::triangle_of(side)].centre,
              &q = diagram_.circle[triangulation::triangle_of(mesh.twin(side))].centre;
  const double of_p = along_x_ * (p.y - a_.y) - along_y_ * (p.x - a_.x),
               of_q = along_x_ * (q.y - a_.y) - along_y_ * (q.x - a_.x);
  if ((of_p > 0) == (of_q > 0)) return;
  const double along = of_p / (of_p - of_q);
  const Point at{p.x + along * (q.x - p.x), p.y + along * (q.y - p.y)};
  const double radius = distance(at, mesh.points[mesh.origin(side)]);
  narrow_ |= apart(at) <= margin_;
  const std::uint32_t sites[] = {mesh.origin(side), mesh.target(side)};
  judge(at, radius, sites);
}

/// `sites`: some to which the place belongs, all at the distance `radius`.
void PieceCheck::judge(const Point& at, double radius, std::span<const std::uint32_t> sites) {
  const double from_piece = apart(at), depth = radius - from_piece;
  if (depth <= room_.sampling) {
    depth_ = std::max(depth_, depth);
    return;
  }
  for (const std::uint32_t site : sites)
    if (diagram_.object[site] != object_) relax(at, from_piece, radius, site);
}

void PieceCheck::relax(const Point& at, double from_piece, double radius, std::uint32_t site) {
  auto relaxed = std::find_if(relaxed_.begin(), relaxed_.end(), [&](const Relaxed& r) { return r.site == site; });
  if (relaxed == relaxed_.end()) relaxed = relaxed_.insert(relaxed_.end(), {site, {0, 0, 0}});
  const Mesh& mesh = diagram_.mesh;
  const auto keep = [&](int i, double from_object) {
    relaxed->difference[i] = std::max(relaxed->difference[i], from_object - from_piece);
  };
  Point end[2];
  for (const int i : {0, 1}) {
    end[i] = mesh.points[site];
    if (const std::uint32_t piece = ends_.at_vertex[site][i]; piece != none) {
      const auto [first, last, object] = ends_.of_piece[piece];
      end[i] = mesh.points[first == site ? last : first];
    }
    keep(i, distance_from_segment(at, mesh.points[site], end[i]));
  }
  const bool straight_on = distance_from_segment(mesh.points[site], end[0], end[1]) <= margin_;
  keep(2, straight_on ? distance_from_segment(at, end[0], end[1]) : radius);
  if (relaxed->needed() > room_.sampling) radius_ = std::max(radius_, radius);
}

}  // namespace oblast::internal::zoning
