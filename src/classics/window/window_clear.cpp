// The edges that count keep clear of all near ones: then noding would cut them at the window only.
#include <atomic>

#include "classics/far.h"
#include "classics/window/window_clip.h"
#include "exact/orientation.h"
#include "noding/pair_finder.h"

namespace oblast::classics {

using exact::orientation;

bool WindowClip::core_is_clear() const {
  // Up to here, to look at every pair is quicker than to set up a search.
  constexpr std::size_t few_pairs = 3000;
  std::size_t near = 0, core = 0;
  for (const Stretch& s : stretches_) {
    near += s.last - s.first;
    if (s.core) core += s.last - s.first;
  }
  return near * core <= few_pairs ? every_pair_is_clear() : near_pairs_are_clear();
}

//        q                     Neighbours (p, q) and (r, s), q = r, keep clear when the far end of each does;
//   p --' `-- s                others when all ends do and they do not cross.
bool WindowClip::pair_is_clear(const Ring& a, Index i, const Ring& b, Index j) const {
  const Point &p = a.from(i), &q = a.to(i), &r = b.from(j), &s = b.to(j);
  const bool follows = &a == &b && a.after(i) == j, precedes = &a == &b && b.after(j) == i;
  if (follows) return is_far(s, p, q, gap_) && is_far(p, r, s, gap_);
  if (precedes) return is_far(r, p, q, gap_) && is_far(q, r, s, gap_);
  if (!is_far(p, r, s, gap_) || !is_far(q, r, s, gap_) || !is_far(r, p, q, gap_) || !is_far(s, p, q, gap_))
    return false;
  return orientation(p, q, r) * orientation(p, q, s) >= 0 || orientation(r, s, p) * orientation(r, s, q) >= 0;
}

bool WindowClip::every_pair_is_clear() const {
  for (std::size_t k = 0; k < stretches_.size(); ++k) {
    const Stretch& a = stretches_[k];
    if (!a.core) continue;
    for (Index i = a.first; i < a.last; ++i) {
      for (std::size_t l = 0; l < stretches_.size(); ++l) {
        const Stretch& b = stretches_[l];
        if (b.core && l < k) continue;
        if (!edge_is_clear(rings_[a.ring], i, rings_[b.ring], k == l ? i + 1 : b.first, b.last)) return false;
      }
    }
  }
  return true;
}

/// Edge i of a against edges [first, last) of b.
bool WindowClip::edge_is_clear(const Ring& a, Index i, const Ring& b, Index first, Index last) const {
  const Box box = grown(Box::of(a.from(i), a.to(i)));
  Point r = first < last ? b.from(first) : Point{};
  for (Index j = first; j < last; ++j) {
    const Point s = b.to(j);
    if (box.meets(Box::of(r, s)) && !pair_is_clear(a, i, b, j)) return false;
    r = s;
  }
  return true;
}

bool WindowClip::near_pairs_are_clear() const {
  using noding::Run;
  constexpr noding::Group off_core = 1;  // these need not keep clear of each other
  std::vector<Run> runs;
  for (const Stretch& stretch : stretches_) {
    const Ring& ring = rings_[stretch.ring];
    for (Index first = stretch.first; first < stretch.last;) {
      Box box = Box::of(ring.from(first), ring.to(first));
      const bool rises = ring.from(first).y <= ring.to(first).y, right = ring.from(first).x <= ring.to(first).x;
      Index last = first + 1;
      for (; last < stretch.last && last - first < noding::longest_run; ++last) {
        const Point &p = ring.from(last), &q = ring.to(last);
        if ((p.y <= q.y) != rises || (p.x <= q.x) != right) break;
        // In a monotone run only neighbours can come near each other, unless an edge is hardly longer than the gap.
        if (stretch.core && !pair_is_clear(ring, last - 1, ring, last)) return false;
        if (std::max(std::abs(p.x - q.x), std::abs(p.y - q.y)) <= 4 * gap_) return false;
        const Box edge = Box::of(p, q);
        box = {std::min(box.x0, edge.x0), std::min(box.y0, edge.y0), std::max(box.x1, edge.x1),
               std::max(box.y1, edge.y1)};
      }
      runs.push_back({grown(box), ring.offset + first, ring.offset + last, stretch.core ? noding::any_group : off_core});
      first = last;
    }
  }
  const auto ring_of = [&](Index edge) -> const Ring& {
    return *(std::upper_bound(rings_.begin(), rings_.end(), edge,
                              [](Index e, const Ring& ring) { return e < ring.offset; }) -
             1);
  };
  std::atomic<bool> clear = true;
  const auto visit = [&](std::span<const noding::RunPair> pairs) {
    for (const noding::RunPair& pair : pairs) {
      if (!clear.load(std::memory_order_relaxed)) return;
      const Ring &a = ring_of(pair.first_p), &b = ring_of(pair.first_q);
      for (Index i = pair.first_p; i < pair.last_p; ++i)
        if (!edge_is_clear(a, i - a.offset, b, pair.first_q - b.offset, pair.last_q - b.offset))
          clear.store(false, std::memory_order_relaxed);
    }
  };
  noding::find_pairs(subject_.points, std::move(runs), visit, noding::PairGoal::boxes);
  return clear;
}

}  // namespace oblast::classics
