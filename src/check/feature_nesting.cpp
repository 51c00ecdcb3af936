#include "check/feature_nesting.h"

#include <algorithm>
#include <numeric>

#include "base/disjoint_sets.h"

namespace oblast::internal::checking {
namespace {

using enum FeatureFaultKind;
constexpr std::uint32_t none = FeaturePlace::none;

class NestingCheck {
 public:
  NestingCheck(const FeatureRings& rings, const RingNesting& nesting, std::vector<FeatureFault>& faults)
      : rings_(rings), nesting_(nesting), faults_(faults), shell_(rings.size(), none), bad_(rings.size(), 0) {
    // The rings of a part follow one another, so its shell is the first; it may be missing.
    for (std::uint32_t r = 0, first = 0; r < rings.size(); ++r) {
      if (rings.polygon[r] != rings.polygon[first]) first = r;
      if (!rings.is_hole[first]) shell_[r] = first;
    }
  }

  void look_at(std::uint32_t ring) {
    if (rings_.broken[ring]) return;
    if ((nesting_.is_ccw[ring] != 0) == (rings_.is_hole[ring] != 0)) add(wrong_orientation, ring, none);
    rings_.is_hole[ring] ? look_at_hole(ring) : look_at_shell(ring);
  }

  void find_cuts(Array<RingTouch> touches);

 private:
  void add(FeatureFaultKind kind, std::uint32_t ring, std::uint32_t other) {
    const std::uint32_t at = rings_.begin(ring);
    if (!is_note(kind)) bad_[ring] = 1;
    faults_.push_back({kind, rings_.place(ring, at),
                       other == none ? FeaturePlace{} : rings_.place(other, rings_.begin(other)), rings_.points[at]});
  }

  /// A shell may lie in a hole of another part.
  void look_at_shell(std::uint32_t ring) {
    const std::uint32_t parent = nesting_.parent[ring];
    if (parent != none && !rings_.is_hole[parent]) add(parts_overlap, ring, parent);
  }

  void look_at_hole(std::uint32_t ring) {
    const std::uint32_t shell = shell_[ring];
    if (shell == none || rings_.broken[shell]) return;
    for (std::uint32_t around = nesting_.parent[ring]; around != none; around = nesting_.parent[around]) {
      if (around == shell) return;
      if (rings_.polygon[around] == rings_.polygon[ring]) return add(holes_overlap, ring, around);
    }
    add(hole_outside_shell, ring, shell);
  }

  const FeatureRings& rings_;
  const RingNesting& nesting_;
  std::vector<FeatureFault>& faults_;
  Array<std::uint32_t> shell_;  ///< by ring: that of its part
  Array<std::uint8_t> bad_;     ///< by ring
};

/// The rings of a part and the points at which they touch are the nodes of a graph. If its interior is one area, the
/// graph has no cycle: a cycle is a closed way along rings that has interior on both sides.
void NestingCheck::find_cuts(Array<RingTouch> touches) {
  std::sort(touches.begin(), touches.end(), [](const RingTouch& a, const RingTouch& b) {
    if (a.point != b.point) return lexicographically_less(a.point, b.point);
    return a.ring != b.ring ? a.ring < b.ring : a.other_ring < b.other_ring;
  });
  Array<std::uint8_t> bad_part(rings_.size(), 0);  // by its first ring
  Array<std::uint32_t> first(rings_.size(), 0);
  for (std::uint32_t r = 0; r < rings_.size(); ++r) {
    first[r] = r > 0 && rings_.polygon[r] == rings_.polygon[r - 1] ? first[r - 1] : r;
    bad_part[first[r]] |= static_cast<std::uint8_t>(rings_.broken[r] | bad_[r]);
  }
  const auto count = static_cast<std::uint32_t>(rings_.size());
  DisjointSets sets(count + 2 * touches.size());
  std::uint32_t node = count;
  Array<std::pair<std::uint32_t, std::uint32_t>> at_point;  // part, node
  Array<std::pair<std::uint32_t, std::uint32_t>> joined;    // ring, node
  for (std::size_t t = 0; t < touches.size(); ++t) {
    const RingTouch& touch = touches[t];
    if (t == 0 || touches[t - 1].point != touch.point) at_point.clear(), joined.clear();
    const std::uint32_t part = first[touch.ring];
    if (bad_part[part]) continue;
    auto there = std::find_if(at_point.begin(), at_point.end(), [&](const auto& p) { return p.first == part; });
    if (there == at_point.end()) there = at_point.insert(at_point.end(), {part, node++});
    for (const std::uint32_t ring : {touch.ring, touch.other_ring}) {
      const std::pair pair{ring, there->second};
      if (std::find(joined.begin(), joined.end(), pair) != joined.end()) continue;
      joined.push_back(pair);
      if (sets.find(ring) == sets.find(there->second))
        faults_.push_back({interior_cut, rings_.place(touch.ring, touch.index),
                           rings_.place(touch.other_ring, touch.other_index), touch.point});
      sets.unite(ring, there->second);
    }
  }
}

}  // namespace

void give_roles(FeatureRings& rings, const RingNesting& nesting) {
  const auto count = static_cast<std::uint32_t>(rings.size());
  Array<std::uint32_t> part(count), order(count);
  for (std::uint32_t r = 0, shell = 0; r < count; ++r) {
    std::uint32_t depth = 0;
    for (std::uint32_t s = nesting.parent[r]; s != none; s = nesting.parent[s]) ++depth;
    // Of a broken ring only the direction is known. Its part is that of the shell before, as most programs write it.
    const bool is_hole = rings.broken[r] ? r > 0 && nesting.is_ccw[r] == 0 : depth % 2 != 0;
    if (!is_hole) shell = r;
    part[r] = !is_hole ? r : rings.broken[r] ? part[shell] : nesting.parent[r];
    rings.is_hole[r] = is_hole;
    order[r] = r;
  }
  for (std::uint32_t r = 0; r < count; ++r) rings.polygon[r] = part[r];
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (part[a] != part[b]) return part[a] < part[b];
    return rings.is_hole[a] != rings.is_hole[b] ? !rings.is_hole[a] : a < b;
  });
  std::fill(rings.broken.begin(), rings.broken.end(), std::uint8_t{0});
  keep_rings(rings, order);
}

void find_bad_nesting(const FeatureRings& rings, const RingNesting& nesting, Array<RingTouch> touches,
                      std::vector<FeatureFault>& faults) {
  NestingCheck check(rings, nesting, faults);
  for (std::uint32_t r = 0; r < rings.size(); ++r) check.look_at(r);
  if (touches.size() > 1) check.find_cuts(std::move(touches));
}

}  // namespace oblast::internal::checking
