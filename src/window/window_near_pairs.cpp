// The test of all near pairs for many edges: edges make runs, runs make blocks, and a sweep goes over the blocks.
//
//   stretch   e0 e1 ... e7 | e8 ... e15 | e16 ...       a run: a few edges in a row, with their box
//   runs      [  run 0    ]  [  run 1  ]  [ run 2       a block: a few runs in a row, with their box
//   blocks    [           block 0          ...
//
//   sweep     |--- a ---|                  Blocks are sorted by their begin along the longer side of the reach.
//                 |--- b ---|              Block a is compared with the blocks that begin before it ends:
//                         |--- c ---|      with b, but not with c.
//
// Where the boxes of two blocks meet, their runs are compared, and where the boxes of two runs meet, their edges.
#include <algorithm>

#include "base/call_memory.h"
#include "base/tuning.h"
#include "window/window_clip.h"

namespace oblast::internal::window {

class WindowClip::NearPairs {
 public:
  explicit NearPairs(const WindowClip& clip) : clip_(clip) {
    for (const Stretch& s : clip.stretches_) {
      budget_ += tuning::window_tests_an_edge * (s.last - s.first);
      for (Index first = s.first; first < s.last; first += edges_a_run)
        add_run(s, first, std::min(first + edges_a_run, s.last));
    }
    const Box& reach = clip.reach_;
    by_x_ = reach.x1 - reach.x0 >= reach.y1 - reach.y0;
    std::sort(blocks_.begin(), blocks_.end(), [&](const Block& a, const Block& b) { return begin(a) < begin(b); });
  }

  /// False also when the budget of tests is spent. Then boxes tell too little, as of long edges side by side, and the
  /// search of noding, which cuts edges, is quicker.
  bool are_clear() {
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      for (std::size_t j = i; j < blocks_.size() && begin(blocks_[j]) <= end(blocks_[i]); ++j) {
        if (++tests_ > budget_) return false;
        if (!blocks_are_clear(i, j)) return false;
      }
    }
    return true;
  }

 private:
  static constexpr Index edges_a_run = tuning::window_edges_a_run, runs_a_block = tuning::window_runs_a_block;

  /// Boxes are wider than the edges by the gap. Core: some of the edges count in the result.
  struct Run {
    Box box;
    Index ring, first, last;
    bool core;
  };
  struct Block {
    Box box;
    Index first, last;  ///< runs
    bool core;
  };

  /// Edges [first, last) of a stretch.
  void add_run(const Stretch& s, Index first, Index last) {
    const Ring& ring = clip_.rings_[s.ring];
    Box box = Box::of(ring.from(first), ring.to(first));
    for (Index i = first; i < last; ++i) box = box.joined(ring.to(i));
    box = box.widened(clip_.gap_);
    const auto run = static_cast<Index>(runs_.size());
    runs_.push_back({box, s.ring, first, last, s.core});
    if (run % runs_a_block == 0) blocks_.push_back({box, run, run, false});
    Block& block = blocks_.back();
    block = {block.box.joined(box), block.first, run + 1, block.core || s.core};
  }

  double begin(const Block& b) const { return by_x_ ? b.box.x0 : b.box.y0; }
  double end(const Block& b) const { return by_x_ ? b.box.x1 : b.box.y1; }

  /// Pairs of which no edge counts in the result may come near each other.
  template <class Item>
  static bool matters(const Item& a, const Item& b) {
    return (a.core || b.core) && a.box.meets(b.box);
  }

  bool blocks_are_clear(std::size_t i, std::size_t j) {
    const Block &a = blocks_[i], &b = blocks_[j];
    if (!matters(a, b)) return true;
    for (Index k = a.first; k < a.last; ++k)
      for (Index l = i == j ? k : b.first; l < b.last; ++l)
        if (!runs_are_clear(k, l)) return false;
    return true;
  }

  bool runs_are_clear(Index k, Index l) {
    const Run &a = runs_[k], &b = runs_[l];
    if (!matters(a, b)) return true;
    tests_ += static_cast<std::size_t>(a.last - a.first) * (b.last - b.first);
    for (Index i = a.first; i < a.last; ++i)
      if (!clip_.edge_is_clear(clip_.rings_[a.ring], i, clip_.rings_[b.ring], k == l ? i + 1 : b.first, b.last))
        return false;
    return true;
  }

  const WindowClip& clip_;
  Array<Run> runs_;
  Array<Block> blocks_;
  bool by_x_ = false;  ///< the sweep goes along x, else along y
  std::size_t tests_ = 0, budget_ = 0;
};

bool WindowClip::near_pairs_are_clear() const { return NearPairs(*this).are_clear(); }

}  // namespace oblast::internal::window
