// The sweep. Edges do not cross, so their order from below to above is the same wherever two of them are side by side.
//
//            ____b____
//      q .--'                the line stands at q, the first vertex of a ring;
//        '--.____c____       c is its lower edge there, and e the edge below c.
//     ------e---------       If the inside of e's ring is above e, q's ring lies in it; else both lie in the same ring.
#include <algorithm>
#include <iterator>
#include <set>

#include "base/parallel.h"
#include "check/feature_nesting.h"
#include "exact/orientation.h"

namespace oblast::internal::checking {
namespace {

constexpr std::uint32_t none = FeaturePlace::none;

class Sweep {
 public:
  explicit Sweep(const FeatureRings& rings)
      : rings_(rings), status_(Below{this}), lowest_(rings.size(), none), below_(rings.size(), none) {}

  RingNesting run() {
    find_lowest_edges();
    pass_over_edges();
    RingNesting nesting{Array<std::uint32_t>(rings_.size(), none), Array<std::uint8_t>(rings_.size(), 0)};
    for (std::uint32_t r = 0; r < rings_.size(); ++r) nesting.is_ccw[r] = lowest_[r] != none && is_forward(lowest_[r]);
    find_parents(nesting);
    return nesting;
  }

 private:
  struct Below {
    const Sweep* sweep;
    bool operator()(std::uint32_t e, std::uint32_t f) const { return sweep->is_below(e, f); }
  };
  using Status = std::set<std::uint32_t, Below, CallAllocator<std::uint32_t>>;

  bool is_forward(std::uint32_t e) const { return lexicographically_less(rings_.points[e], rings_.points[e + 1]); }
  const Point& left(std::uint32_t e) const { return rings_.points[is_forward(e) ? e : e + 1]; }
  const Point& right(std::uint32_t e) const { return rings_.points[is_forward(e) ? e + 1 : e]; }

  /// REQUIRES: there is a place of the line at which both are.
  bool is_below(std::uint32_t e, std::uint32_t f) const {
    if (e == f) return false;
    if (lexicographically_less(left(f), left(e))) return !is_below_later(f, e);
    return is_below_later(e, f);
  }
  /// f begins where e does, or later.
  bool is_below_later(std::uint32_t e, std::uint32_t f) const {
    const int side = exact::orientation(left(e), right(e), left(f));
    return (side != 0 ? side : exact::orientation(left(e), right(e), right(f))) > 0;
  }

  /// By ring: the lower one of the edges that leave its smallest vertex. Outside is below it.
  void find_lowest_edges() {
    for (std::uint32_t r = 0; r < rings_.size(); ++r) {
      std::uint32_t& lowest = lowest_[r];
      for (std::uint32_t e = rings_.begin(r); e + 1 < rings_.ends[r]; ++e) {
        if (!rings_.broken[r]) edges_.push_back(e);
        if (lowest == none || lexicographically_less(left(e), left(lowest)) ||
            (left(e) == left(lowest) && is_below(e, lowest)))
          lowest = e;
      }
    }
  }

  void pass_over_edges() {
    Array<std::uint32_t> begins = edges_, ends = edges_;
    parallel_sort(begins.begin(), begins.end(), [&](std::uint32_t e, std::uint32_t f) {
      return left(e) == left(f) ? e < f : lexicographically_less(left(e), left(f));
    });
    parallel_sort(ends.begin(), ends.end(), [&](std::uint32_t e, std::uint32_t f) {
      return right(e) == right(f) ? e < f : lexicographically_less(right(e), right(f));
    });
    Array<Status::iterator> places(rings_.points.size());
    Steps steps(begins.size());
    for (std::size_t b = 0, e = 0; b < begins.size();) {
      const Point at = left(begins[b]);
      for (; e < ends.size() && !lexicographically_less(at, right(ends[e])); ++e) {
        steps();
        status_.erase(places[ends[e]]);
      }
      const std::size_t first = b;
      for (; b < begins.size() && left(begins[b]) == at; ++b) places[begins[b]] = status_.insert(begins[b]).first;
      for (std::size_t i = first; i < b; ++i) look_below(begins[i], places[begins[i]]);
    }
  }

  void look_below(std::uint32_t e, Status::iterator place) {
    const std::uint32_t ring = rings_.ring_of(e);
    if (lowest_[ring] == e && place != status_.begin()) below_[ring] = *std::prev(place);
  }

  /// From edges below to rings around.
  void find_parents(RingNesting& nesting) const {
    Array<std::uint8_t> known(rings_.size(), 0);
    Array<std::uint32_t> chain;
    for (std::uint32_t r = 0; r < rings_.size(); ++r) {
      chain.clear();
      std::uint32_t s = r, parent = none;
      for (;;) {
        if (known[s]) {
          parent = nesting.parent[s];
          break;
        }
        chain.push_back(s);
        if (below_[s] == none) break;
        const std::uint32_t other = rings_.ring_of(below_[s]);
        if (is_forward(below_[s]) == (nesting.is_ccw[other] != 0)) {
          parent = other;
          break;
        }
        s = other;
      }
      for (const std::uint32_t c : chain) nesting.parent[c] = parent, known[c] = 1;
    }
  }

  const FeatureRings& rings_;
  Status status_;
  Array<std::uint32_t> edges_;
  Array<std::uint32_t> lowest_;  ///< by ring
  Array<std::uint32_t> below_;   ///< by ring: the edge directly below its lowest one
};

}  // namespace

RingNesting nest_rings(const FeatureRings& rings) { return Sweep(rings).run(); }

}  // namespace oblast::internal::checking
