// Step 3 of repair_coverage: parts of features that are too small.
//
//   a a a a a a      First the slivers beside parts that stay go to one of these (s), then those beside them
//   s s s t t        (t), and so on in waves: each sliver is decided once, by what was settled before its wave.
//   b b b b s        The waves do not depend on the order of the polygons.
#include <algorithm>

#include "base/index.h"
#include "base/parallel.h"
#include "repair/owned_pieces.h"
#include "repair/shared_borders.h"

namespace oblast::internal::repairing {
namespace {

class Slivers {
 public:
  Slivers(const FeatureSet& rows, const SizeBounds& bounds, std::vector<CoverageRepair>& changes)
      : rows_(rows), parts_(rows.regions), changes_(changes) {
    for (std::uint32_t f = 0; f < rows.size(); ++f) owner_.resize(rows.feature_ends[f], f);
    find(bounds);
  }

  bool empty() const { return slivers_.empty(); }

  /// The owners of all parts. `moved`: whether some changed.
  Array<std::uint32_t> run(bool& moved) {
    borders_ = find_shared_borders(parts_, slivers_);
    moved = false;
    for (Array<std::uint32_t> wave = first_wave(); !wave.empty(); wave = next_wave(wave)) {
      Array<std::uint32_t> owners;
      for (const std::uint32_t k : wave) owners.push_back(choose(k));
      for (std::size_t i = 0; i < wave.size(); ++i) moved |= settle(wave[i], owners[i]);
    }
    return std::move(owner_);
  }

 private:
  void find(const SizeBounds& bounds) {
    Array<ExactSum> area(owner_.size());
    Array<std::uint8_t> small(owner_.size());
    for_ranges(area.size(), grain(area.size(), parts_.points.size()), [&](std::size_t p, std::size_t end) {
      for (; p < end; ++p) {
        area[p] = twice_area(parts_.polygon(p));
        small[p] = is_below(bounds, parts_.polygon(p), area[p]);
      }
    });
    for (std::uint32_t f = 0, begin = 0; f < rows_.size(); begin = rows_.feature_ends[f++]) {
      std::uint32_t largest = begin;
      for (std::uint32_t p = begin + 1; p < rows_.feature_ends[f]; ++p) {
        ExactSum difference = area[p];
        difference.subtract(area[largest]);
        if (difference.sign() > 0) largest = p;
      }
      for (std::uint32_t p = begin; p < rows_.feature_ends[f]; ++p)
        if (small[p] && p != largest) slivers_.push_back(p);
    }
    sliver_at_.assign(owner_.size(), none);
    for (std::uint32_t k = 0; k < slivers_.size(); ++k) sliver_at_[slivers_[k]] = k;
  }

  bool is_settled(std::uint32_t part) const { return sliver_at_[part] == none; }

  Array<std::uint32_t> first_wave() const {
    Array<std::uint32_t> wave;
    for (std::uint32_t k = 0; k < slivers_.size(); ++k) {
      const auto edges = borders_.of(k);
      if (std::any_of(edges.begin(), edges.end(), [&](const SharedEdge& e) { return is_settled(e.neighbour); }))
        wave.push_back(k);
    }
    return wave;
  }

  Array<std::uint32_t> next_wave(const Array<std::uint32_t>& wave) const {
    Array<std::uint32_t> next;
    for (const std::uint32_t k : wave)
      for (const SharedEdge& edge : borders_.of(k))
        if (!is_settled(edge.neighbour)) next.push_back(sliver_at_[edge.neighbour]);
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    return next;
  }

  std::uint32_t choose(std::uint32_t k) const {
    Array<OwnedLength> lengths;
    for (const SharedEdge& edge : borders_.of(k))
      if (is_settled(edge.neighbour)) lengths.push_back({owner_[edge.neighbour], edge.length});
    return longest_owner(std::move(lengths));
  }

  bool settle(std::uint32_t k, std::uint32_t owner) {
    const std::uint32_t part = slivers_[k];
    sliver_at_[part] = none;
    if (owner == owner_[part]) return false;
    changes_.push_back(change_of(CoverageChange::sliver, {owner_[part]}, owner, parts_.polygon(part)));
    owner_[part] = owner;
    return true;
  }

  const FeatureSet& rows_;
  RegionView parts_;  ///< polygons of the rows
  std::vector<CoverageRepair>& changes_;
  Array<std::uint32_t> owner_;      ///< by part
  Array<std::uint32_t> slivers_;    ///< parts
  Array<std::uint32_t> sliver_at_;  ///< by part: its place among the slivers; none when it is settled
  SharedBorders borders_;           ///< of the slivers
};

}  // namespace

void move_slivers(FeatureSet& rows, const SizeBounds& bounds, std::vector<CoverageRepair>& changes) {
  if (bounds.empty()) return;
  for (bool moved = true; moved;) {
    Slivers slivers(rows, bounds, changes);
    if (slivers.empty()) return;
    Array<std::uint32_t> owners = slivers.run(moved);
    if (!moved) return;
    const Share share(0.5);
    rows = unite_by_owner({Charge(bytes_of(rows.regions)), std::move(rows.regions), std::move(owners)}, rows.size());
  }
}

}  // namespace oblast::internal::repairing
