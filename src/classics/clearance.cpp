#include "classics/clearance.h"

#include <algorithm>
#include <cmath>

#include "base/call_memory.h"
#include "base/tuning.h"
#include "noding/monotone_runs.h"
#include "plane/box_tree.h"
#include "plane/far.h"

namespace oblast::internal::classics {
namespace {

using noding::Strands;

class ClearanceTest {
 public:
  explicit ClearanceTest(const Strands& noded) : strands_(noded), points_(noded.points) {
    double largest = 0;
    for (const Point& p : points_) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
    gap_ = clearance_gap(largest);
    for (std::uint32_t s = 0; s < noded.size(); ++s)
      for (std::uint32_t e = noded.begin(s); e + 1 < noded.ends[s]; ++e)
        if (noded.flags[e] & noding::moved_flag) moved_.push_back({e, s});
  }

  bool run() const {
    if (moved_.empty()) return true;
    // With few moved pieces, comparing all edges is faster than building a tree.
    if (moved_.size() * points_.size() <= tuning::few_moved_pairs) {
      return each_moved([&](std::uint32_t e, std::uint32_t s, const Box& box) {
        for (std::uint32_t t = 0; t < strands_.size(); ++t)
          for (std::uint32_t f = strands_.begin(t); f + 1 < strands_.ends[t]; ++f)
            if (!pair_is_clear(e, s, box, f, t)) return false;
        return true;
      });
    }
    const LargeArray<noding::Run> runs = noding::monotone_runs(strands_, noding::Grouping::by_moved);
    LargeArray<Box> boxes;
    for (const noding::Run& run : runs) boxes.push_back(run.box);
    const BoxTree tree(boxes);
    return each_moved([&](std::uint32_t e, std::uint32_t s, const Box& box) {
      return tree.for_each_near(box, [&](std::uint32_t r) {
        const noding::Run& run = runs[r];
        const auto t = static_cast<std::uint32_t>(strands_.strand_of(run.first));
        for (std::uint32_t f = run.first; f < run.last; ++f)
          if (!pair_is_clear(e, s, box, f, t)) return false;
        return true;
      });
    });
  }

 private:
  struct Moved {
    std::uint32_t edge, strand;
  };

  template <class Test>
  bool each_moved(const Test& test) const {
    return std::all_of(moved_.begin(), moved_.end(), [&](const Moved& m) {
      Box box = Box::of(points_[m.edge], points_[m.edge + 1]);
      box = box.widened(gap_);
      return test(m.edge, m.strand, box);
    });
  }

  /// Compares edge e of strand s, in its enlarged box, with edge f of strand t.
  bool pair_is_clear(std::uint32_t e, std::uint32_t s, const Box& box, std::uint32_t f, std::uint32_t t) const {
    const Point &a = points_[e], &b = points_[e + 1], &c = points_[f], &d = points_[f + 1];
    if (e == f || !box.meets(Box::of(c, d))) return true;
    return end_is_clear(a, e, s, c, d, f, t) && end_is_clear(b, e + 1, s, c, d, f, t) &&
           (c == a || c == b || is_far(c, a, b)) && (d == a || d == b || is_far(d, a, b));
  }

  /// Compares vertex v of strand s, at p, with edge f = (c, d) of strand t.
  bool end_is_clear(const Point& p, std::uint32_t v, std::uint32_t s, const Point& c, const Point& d, std::uint32_t f,
                    std::uint32_t t) const {
    if (p != c && p != d) return is_far(p, c, d);
    const std::uint32_t w = p == c ? f : f + 1;
    if (same_vertex(v, w, s, t)) return true;
    const bool added = (strands_.flags[v] & noding::added_flag) != 0;
    if (added != ((strands_.flags[w] & noding::added_flag) != 0)) return false;
    return !added || strands_.change[s] != strands_.change[t];
  }

  /// True for one vertex, and for the first and the last one of a closed strand.
  bool same_vertex(std::uint32_t v, std::uint32_t w, std::uint32_t s, std::uint32_t t) const {
    if (v == w) return true;
    if (s != t) return false;
    const std::uint32_t first = strands_.begin(s), last = strands_.ends[s] - 1;
    return (v == first && w == last) || (v == last && w == first);
  }

  bool is_far(const Point& p, const Point& a, const Point& b) const { return internal::is_far(p, a, b, gap_); }

  const Strands& strands_;
  const LargeArray<Point>& points_;
  double gap_ = 0;
  Array<Moved> moved_;
};

}  // namespace

bool is_clear(const Strands& noded) { return ClearanceTest(noded).run(); }

}  // namespace oblast::internal::classics
