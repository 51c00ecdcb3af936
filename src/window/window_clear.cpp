// The edges that count keep clear of all near ones: then noding would cut them at the window only.
#include "base/tuning.h"
#include "exact/orientation.h"
#include "plane/far.h"
#include "window/window_clip.h"

namespace oblast::internal::window {

using exact::orientation;

/// By looking at every pair, where there are few; else by the boxes of runs (window_near_pairs.cpp).
bool WindowClip::core_is_clear() const {
  std::size_t near = 0, core = 0;
  for (const Stretch& s : stretches_) {
    near += s.last - s.first;
    if (s.core) core += s.last - s.first;
  }
  return near * core <= tuning::few_window_pairs ? every_pair_is_clear() : near_pairs_are_clear();
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
  const Box box = Box::of(a.from(i), a.to(i)).widened(gap_);
  Point r = first < last ? b.from(first) : Point{};
  for (Index j = first; j < last; ++j) {
    const Point s = b.to(j);
    if (box.meets(Box::of(r, s)) && !pair_is_clear(a, i, b, j)) return false;
    r = s;
  }
  return true;
}

}  // namespace oblast::internal::window
