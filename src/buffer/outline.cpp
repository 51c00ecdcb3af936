#include "buffer/outline.h"

#include <cmath>
#include <cstddef>
#include <span>

#include "base/index.h"
#include "buffer/corner_arc.h"
#include "exact/orientation.h"
#include "hull/lee.h"
#include "plane/largest_ulp.h"

namespace oblast::internal::buffering {
namespace {

/// True if the polygon center, rim... is simple and counter-clockwise: all turns from one vertex of the rim to the next
/// go to the left, and together by at most half a turn, or by one if it is closed.
bool is_fan(const Point& center, std::span<const Point> rim) {
  for (std::size_t i = 0; i + 1 < rim.size(); ++i)
    if (exact::orientation(center, rim[i], rim[i + 1]) <= 0) return false;
  return true;
}

/// True if the bevel of the corner would lead so near to the corner that rounding could leave it out of the zone. The
/// path then leads by the corner.
bool turns_right_back(const CornerNormals& corner) {
  constexpr double squared_quotient = 1e-13;  // of the distances of bevel and sides
  return (1 + dot(corner.from, corner.to)) / 2 < squared_quotient;
}

class OutlineWriter {
 public:
  OutlineWriter(const ZoneShape& shape, Outlines& outlines) : shape_(shape), outlines_(outlines) {}

  void write(const Walk& walk) {
    begin_ = outlines_.points.size();
    find_normals(walk);
    find_corners(walk);
    find_pieces(walk);
    for (std::size_t i = 0, before = walk.size() - 1; i < walk.size(); before = i++) {
      const Point at = walk[i].at;
      add(has_piece_[before] ? rim(i).front() : at);
      if (is_sector_[i])
        for (const Point& p : rim(i)) add(p);
      else if (!has_piece_[before] || !has_piece_[i] || !(rim(i).front() == rim(i).back()))
        add(at);
      add(has_piece_[i] ? rim(i).back() : at);
    }
    end_contour();
    write_folded();
    outlines_.corners += walk.size();
  }

  void write_point(const Point& at) {
    begin_ = outlines_.points.size();
    rims_.clear();
    append_disc(shape_, at, rims_);
    if (rims_.empty()) return;
    rims_.push_back(rims_.front());
    if (is_fan(at, rims_)) {
      outlines_.points.insert(outlines_.points.end(), rims_.begin(), rims_.end() - 1);
      end_contour();
    } else {
      fold(rims_);
      write_folded();
    }
    ++outlines_.corners;
  }

 private:
  static std::size_t after(const Walk& walk, std::size_t i) { return i + 1 < walk.size() ? i + 1 : 0; }

  /// Of each edge the unit normal on the right, and the length.
  void find_normals(const Walk& walk) {
    normals_.resize(walk.size()), lengths_.resize(walk.size());
    for (std::size_t i = 0; i < walk.size(); ++i) {
      const Point a = walk[i].at, b = walk[after(walk, i)].at;
      const double dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
      normals_[i] = {dy / length, -dx / length};
      lengths_[i] = length;
    }
  }

  /// Of each corner the rim of its sector, from the end of one edge's side to the begin of the next one's.
  void find_corners(const Walk& walk) {
    rims_.clear(), rim_ends_.clear(), is_sector_.clear();
    for (std::size_t i = 0, before = walk.size() - 1; i < walk.size(); before = i++) {
      const Point at = walk[i].at;
      const bool turns = add_rim(walk, before, i);
      rim_ends_.push_back(rims_.size());
      const bool is_sector = turns && (rim(i).size() == 1 || is_fan(at, rim(i)));
      is_sector_.push_back(is_sector);
      if (turns && !is_sector) fold(at, rim(i));
    }
  }

  /// True if the corner has a piece. If not, the rim is the ends of the two sides alone.
  bool add_rim(const Walk& walk, std::size_t before, std::size_t i) {
    const Point ends[] = {walk[before].at, walk[i].at, walk[after(walk, i)].at};
    double distance = shape_.distance_at(largest_coordinate(ends));
    for (const std::size_t e : {before, i})
      if (walk[e].edge == WalkEdge::lid) distance = shape_.lid_distance(distance, lengths_[e]);
    const CornerNormals corner{walk[i].at, normals_[before], normals_[i], distance};
    const Point from = moved(corner.at, corner.from, distance), to = moved(corner.at, corner.to, distance);
    const Corner kind = walk[i].corner;
    const bool is_bare = kind == Corner::bare || walk[before].edge == WalkEdge::bare || walk[i].edge == WalkEdge::bare;
    const bool is_flat =
        kind == Corner::end ? shape_.cap == Cap::flat : shape_.join == Join::bevel && turns_right_back(corner);
    if (!is_bare && !is_flat) {
      const int turn = exact::orientation(walk[before].at, corner.at, walk[after(walk, i)].at);
      const bool turns_back = dot(corner.from, corner.to) < 0;
      if (turn > 0 || (turn == 0 && turns_back)) {
        if (kind == Corner::end)
          append_cap(shape_, corner, rims_);
        else
          append_join(shape_, corner, rims_);
        return true;
      }
      // Elsewhere the pieces of the edges overlap, unless rounding opened a crack between them.
      if (!turns_back && exact::orientation(corner.at, from, to) > 0) {
        rims_.insert(rims_.end(), {from, to});
        return true;
      }
    }
    rims_.insert(rims_.end(), {from, to});
    return false;
  }

  std::span<const Point> rim(std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : rim_ends_[i - 1];
    return std::span(rims_).subspan(begin, rim_ends_[i] - begin);
  }

  /// Which edges have a piece that is a part of the path.
  void find_pieces(const Walk& walk) {
    has_piece_.clear();
    for (std::size_t i = 0; i < walk.size(); ++i) {
      const std::size_t next = after(walk, i);
      const Point a = walk[i].at, outer[] = {rim(i).back(), rim(next).front(), walk[next].at};
      const bool is_bare = walk[i].edge == WalkEdge::bare;
      has_piece_.push_back(!is_bare && is_fan(a, outer));
      if (!is_bare && !has_piece_.back()) fold(a, outer);
    }
  }

  void add(const Point& p) {
    if (outlines_.points.size() > begin_ && outlines_.points.back() == p) return;
    outlines_.points.push_back(p);
  }

  void end_contour() {
    outlines_.contour_ends.push_back(checked_index(outlines_.points.size(), "vertices of outlines"));
    begin_ = outlines_.points.size();
  }

  void fold(std::span<const Point> piece) {
    ++outlines_.folded_pieces;
    folded_.insert(folded_.end(), piece.begin(), piece.end());
    folded_ends_.push_back(folded_.size());
  }

  void fold(const Point& first, std::span<const Point> others) {
    folded_.push_back(first);
    fold(others);
  }

  void write_folded() {
    std::size_t begin = 0;
    for (const std::size_t end : folded_ends_) {
      Array<Point> piece(folded_.begin() + static_cast<std::ptrdiff_t>(begin),
                         folded_.begin() + static_cast<std::ptrdiff_t>(end));
      begin = end;
      const Array<Point> hull = monotone_chain_hull(piece);
      if (hull.size() < 3) continue;
      outlines_.points.insert(outlines_.points.end(), hull.begin(), hull.end());
      end_contour();
    }
    folded_.clear(), folded_ends_.clear();
  }

  const ZoneShape& shape_;
  Outlines& outlines_;
  std::size_t begin_ = 0;  ///< of the contour that is written
  // By edge, then by corner.
  Array<Point> normals_;
  Array<double> lengths_;
  Array<unsigned char> has_piece_;
  Array<Point> rims_;
  Array<std::size_t> rim_ends_;
  Array<unsigned char> is_sector_;
  Array<Point> folded_;
  Array<std::size_t> folded_ends_;
};

}  // namespace

void append_outline(const ZoneShape& shape, const Walk& walk, Outlines& outlines) {
  OutlineWriter(shape, outlines).write(walk);
}

void append_bare(std::span<const Point> contour, Outlines& outlines) {
  outlines.points.insert(outlines.points.end(), contour.begin(), contour.end());
  outlines.contour_ends.push_back(checked_index(outlines.points.size(), "vertices of outlines"));
}

void append_point_outline(const ZoneShape& shape, const Point& at, Outlines& outlines) {
  OutlineWriter(shape, outlines).write_point(at);
}

}  // namespace oblast::internal::buffering
