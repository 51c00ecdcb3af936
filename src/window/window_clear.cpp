// The edges that count keep clear of all near ones: then noding would cut them at the window only.
#include <algorithm>

#include "base/call_memory.h"
#include "base/tuning.h"
#include "exact/orientation.h"
#include "plane/far.h"
#include "window/window_clip.h"

namespace oblast::internal::window {

using exact::orientation;

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
  const Box box = grown(Box::of(a.from(i), a.to(i)));
  Point r = first < last ? b.from(first) : Point{};
  for (Index j = first; j < last; ++j) {
    const Point s = b.to(j);
    if (box.meets(Box::of(r, s)) && !pair_is_clear(a, i, b, j)) return false;
    r = s;
  }
  return true;
}

/// The same for many edges: runs, blocks of runs, and a sweep over the blocks. Declines where
/// boxes tell too little, as of long edges side by side: then the search of noding, which cuts edges, is quicker.
bool WindowClip::near_pairs_are_clear() const {
  constexpr Index run_size = tuning::window_edges_a_run, runs_a_block = tuning::window_runs_a_block;
  struct Run {
    Box box;
    Index ring, first, last;
    bool core;
  };
  struct Block {
    Box box;
    Index first, last;  // runs
    bool core;
  };
  Array<Run> runs;
  Array<Block> blocks;
  std::size_t budget = 0;
  for (const Stretch& s : stretches_) {
    const Ring& ring = rings_[s.ring];
    budget += tuning::window_tests_an_edge * (s.last - s.first);
    for (Index first = s.first; first < s.last; first += run_size) {
      const Index last = std::min(first + run_size, s.last);
      Box box = Box::of(ring.from(first), ring.to(first));
      for (Index i = first; i < last; ++i) box = around(box, Box::of(ring.to(i), ring.to(i)));
      box = grown(box);
      const auto run = static_cast<Index>(runs.size());
      runs.push_back({box, s.ring, first, last, s.core});
      if (run % runs_a_block == 0) blocks.push_back({box, run, run, false});
      blocks.back() = {around(blocks.back().box, box), blocks.back().first, run + 1, blocks.back().core || s.core};
    }
  }
  const bool wide = reach_.x1 - reach_.x0 >= reach_.y1 - reach_.y0;
  const auto begin = [&](const Block& b) { return wide ? b.box.x0 : b.box.y0; };
  const auto end = [&](const Block& b) { return wide ? b.box.x1 : b.box.y1; };
  std::sort(blocks.begin(), blocks.end(), [&](const Block& a, const Block& b) { return begin(a) < begin(b); });

  std::size_t tests = 0;
  const auto runs_are_clear = [&](Index k, Index l) {
    const Run &a = runs[k], &b = runs[l];
    if (!(a.core || b.core) || !a.box.meets(b.box)) return true;
    tests += static_cast<std::size_t>(a.last - a.first) * (b.last - b.first);
    for (Index i = a.first; i < a.last; ++i)
      if (!edge_is_clear(rings_[a.ring], i, rings_[b.ring], k == l ? i + 1 : b.first, b.last)) return false;
    return true;
  };
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const Block& a = blocks[i];
    for (std::size_t j = i; j < blocks.size() && begin(blocks[j]) <= end(a); ++j) {
      const Block& b = blocks[j];
      if (++tests > budget) return false;
      if (!(a.core || b.core) || !a.box.meets(b.box)) continue;
      for (Index k = a.first; k < a.last; ++k)
        for (Index l = i == j ? k : b.first; l < b.last; ++l)
          if (!runs_are_clear(k, l)) return false;
    }
  }
  return true;
}

}  // namespace oblast::internal::window
