#include "buffer/pockets.h"

#include <algorithm>
#include <cstddef>

#include "exact/orientation.h"
#include "plane/box.h"

namespace oblast::internal::buffering {
namespace {

/// The longest chain that is replaced at once. It decides which lids there are, so it is no matter of tuning. Longer
/// chains would save pieces only where more than so many edges lie within the tolerance of each other.
constexpr std::size_t longest_chain = 256;

struct Vertex {
  Point at;
  std::size_t index;
};

class PocketCloser {
 public:
  PocketCloser(std::span<const Point> path, double widest, bool both) : path_(path), widest_(widest), both_(both) {}

  ClosedPath run() {
    // A chain is at most half of the path: a ring is not one chain.
    longest_ = std::min(longest_chain, (path_.size() - 1) / 2);
    ends_.push_back(path_.size() - 1);
    std::size_t begin = 0;
    while (!ends_.empty()) {
      if (begin == ends_.back())
        ends_.pop_back();
      else
        begin = advance(begin, chain_end(begin, ends_.back()));
    }
    add(result_.right, path_.back(), WalkEdge::bare);
    if (both_) add(result_.left, path_.back(), WalkEdge::bare);
    return std::move(result_);
  }

 private:
  /// The last vertex, not after `end`, up to which the path stays in a box with a diagonal of at most `widest`.
  std::size_t chain_end(std::size_t begin, std::size_t end) const {
    double low_x = path_[begin].x, high_x = low_x, low_y = path_[begin].y, high_y = low_y;
    std::size_t last = begin + 1;
    for (std::size_t i = last; i <= end && i - begin <= longest_; ++i) {
      low_x = std::min(low_x, path_[i].x), high_x = std::max(high_x, path_[i].x);
      low_y = std::min(low_y, path_[i].y), high_y = std::max(high_y, path_[i].y);
      const double width = high_x - low_x, height = high_y - low_y;
      if (width * width + height * height > widest_ * widest_) break;
      last = i;
    }
    return last;
  }

  /// Adds an edge or a chain from `begin`, not beyond `end`. Returns where it ends.
  std::size_t advance(std::size_t begin, std::size_t end) {
    if (end == begin + 1) {
      add(result_.right, path_[begin], WalkEdge::offset);
      if (both_) add(result_.left, path_[begin], WalkEdge::offset);
      return end;
    }
    find_hull(begin, end);
    const auto is_corner = [&](std::size_t i) {
      return std::any_of(hull_.begin(), hull_.end(), [&](const Vertex& v) { return v.at == path_[i]; });
    };
    std::size_t first = begin, last = end;
    while (!is_corner(first)) ++first;
    while (!is_corner(last)) --last;
    if (first > begin) {
      // What comes before the first corner is a chain, or several, of its own.
      ends_.push_back(first);
      return begin;
    }
    add_sides(first, last);
    return last;
  }

  /// The corners of the hull of a chain, counter-clockwise, each with the first of its vertices there (Andrew 1979).
  void find_hull(std::size_t begin, std::size_t end) {
    chain_.clear(), hull_.clear();
    for (std::size_t i = begin; i <= end; ++i) chain_.push_back({path_[i], i});
    std::sort(chain_.begin(), chain_.end(), [](const Vertex& v, const Vertex& w) {
      return v.at == w.at ? v.index < w.index : lexicographically_less(v.at, w.at);
    });
    const auto same = [](const Vertex& v, const Vertex& w) { return v.at == w.at; };
    chain_.erase(std::unique(chain_.begin(), chain_.end(), same), chain_.end());
    const auto push = [&](const Vertex& v, std::size_t bottom) {
      while (hull_.size() > bottom && exact::orientation(hull_[hull_.size() - 2].at, hull_.back().at, v.at) <= 0)
        hull_.pop_back();
      hull_.push_back(v);
    };
    for (const Vertex& v : chain_) push(v, 1);
    const std::size_t bottom = hull_.size();
    for (std::size_t i = chain_.size() - 1; i-- > 0;) push(chain_[i], bottom);
    hull_.pop_back();
  }

  void add_sides(std::size_t first, std::size_t last) {
    const auto corner_at = [&](const Point& p) {
      const auto found = std::find_if(hull_.begin(), hull_.end(), [&](const Vertex& v) { return v.at == p; });
      return static_cast<std::size_t>(found - hull_.begin());
    };
    const std::size_t size = hull_.size(), from = corner_at(path_[first]), to = corner_at(path_[last]);
    // From a point back to itself, the whole hull is on the right.
    std::size_t k = from;
    do {
      const std::size_t next = (k + 1) % size;
      add_side(result_.right, hull_[k], hull_[next]);
      k = next;
    } while (k != to);
    if (!both_) return;
    for (k = from; k != to;) {
      const std::size_t next = (k + size - 1) % size;
      add_side(result_.left, hull_[k], hull_[next]);
      k = next;
    }
  }

  void add_side(Walk& walk, const Vertex& from, const Vertex& to) {
    const bool is_edge = from.index + 1 == to.index || to.index + 1 == from.index;
    result_.pockets += !is_edge;
    add(walk, from.at, is_edge ? WalkEdge::offset : WalkEdge::lid);
  }

  static void add(Walk& walk, const Point& at, WalkEdge edge) { walk.push_back({at, edge, Corner::join}); }

  std::span<const Point> path_;
  double widest_;
  bool both_;
  std::size_t longest_ = 0;
  Array<std::size_t> ends_;  ///< where the path and its parts that are chains of their own end, the innermost last
  Array<Vertex> chain_, hull_;
  ClosedPath result_;
};

}  // namespace

ClosedPath close_pockets(std::span<const Point> path, double widest, bool both) {
  return PocketCloser(path, widest, both).run();
}

}  // namespace oblast::internal::buffering
