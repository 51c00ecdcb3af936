// The keys of a face: which rows of the result it belongs to (features.h).
//
// Nothing else knows the operation. A border between two faces bounds the rows whose keys one of them has and the other
// one lacks, so what is asked is the difference of two sets of keys. It costs as much as there is of it: sets of
// sources share what they have in common (source_sets.h).
#pragma once

#include <oblast/features.h>

#include <cstdint>

#include "features/face_labels.h"

namespace oblast::internal {

/// Two 32-bit numbers, the first one in the higher bits. Keys are ordered as numbers.
using RowKey = std::uint64_t;

constexpr RowKey row_key(std::uint32_t a, std::uint32_t b = no_feature) { return RowKey{a} << 32 | b; }
constexpr FeatureKey feature_key(RowKey key) {
  return {static_cast<std::uint32_t>(key >> 32), static_cast<std::uint32_t>(key)};
}

class KeyRule {
 public:
  static KeyRule of(FeatureOperation operation) {
    using enum FeatureOperation;
    KeyRule rule(Kind::pairs);
    rule.both_ = operation == intersection || operation == identity || operation == unite;
    rule.a_alone_ = operation != intersection;
    rule.b_alone_ = operation == unite || operation == symmetric_difference;
    return rule;
  }
  /// (i, none) for every source i of A.
  static KeyRule each() { return KeyRule(Kind::each); }
  /// (d, none), d the number of sources of A, where that is not 0.
  static KeyRule count() { return KeyRule(Kind::count); }
  /// (s, none), s the set of sources of A, where that is not empty.
  static KeyRule set() { return KeyRule(Kind::set); }

  /// (i, none), i the first source of A or, where there is none, of B. Two sources of A do not count among these:
  /// places that `frame` does not cover have no key, and neither have those that only B and not `reach` covers
  /// (no_feature: B counts everywhere). REQUIRES: they are above all other sources.
  static KeyRule lowest(std::uint32_t frame, std::uint32_t reach) {
    KeyRule rule(Kind::lowest);
    rule.frame_ = frame;
    rule.reach_ = reach;
    return rule;
  }

  bool is_set() const { return kind_ == Kind::set; }

  /// Whether two faces have the same keys.
  bool same(const LabelSets& sets, FaceLabel l, FaceLabel r) const {
    if (l == r) return true;
    switch (kind_) {
      case Kind::each:
      case Kind::set:
        return l.a == r.a;
      case Kind::count:
        return sets.a.size(l.a) == sets.a.size(r.a);
      case Kind::lowest:
        return lowest_of(sets, l) == lowest_of(sets, r);
      case Kind::pairs:
        break;
    }
    const bool l_both = both_ && l.a != none_ && l.b != none_, r_both = both_ && r.a != none_ && r.b != none_;
    return !l_both && !r_both && a_alone(l) == a_alone(r) && b_alone(l) == b_alone(r);
  }

  /// Calls visit(key) for each key of l that r lacks, each once.
  template <class Visit>
  void for_each_only_in(const LabelSets& sets, FaceLabel l, FaceLabel r, const Visit& visit) const {
    switch (kind_) {
      case Kind::each:
        return sets.a.for_each_only_in(l.a, r.a, [&](std::uint32_t i) { visit(row_key(i)); });
      case Kind::count:
        if (const std::uint32_t d = sets.a.size(l.a); d != 0 && d != sets.a.size(r.a)) visit(row_key(d));
        return;
      case Kind::set:
        if (l.a != none_ && l.a != r.a) visit(row_key(l.a));
        return;
      case Kind::lowest:
        if (const std::uint32_t i = lowest_of(sets, l); i != no_feature && i != lowest_of(sets, r)) visit(row_key(i));
        return;
      case Kind::pairs:
        break;
    }
    const auto pairs_of = [&](std::uint32_t i, SourceSets::Set except) {
      sets.b.for_each_only_in(l.b, except, [&](std::uint32_t j) { visit(row_key(i, j)); });
    };
    if (both_ && l.b != none_) {
      sets.a.for_each_only_in(l.a, r.a, [&](std::uint32_t i) { pairs_of(i, none_); });
      if (l.b != r.b) sets.a.for_each_in_both(l.a, r.a, [&](std::uint32_t i) { pairs_of(i, r.b); });
    }
    sets.a.for_each_only_in(a_alone(l), a_alone(r), [&](std::uint32_t i) { visit(row_key(i)); });
    sets.b.for_each_only_in(b_alone(l), b_alone(r), [&](std::uint32_t j) { visit(row_key(no_feature, j)); });
  }

 private:
  enum class Kind { pairs, each, count, set, lowest };
  static constexpr SourceSets::Set none_ = SourceSets::empty;

  explicit KeyRule(Kind kind) : kind_(kind) {}

  SourceSets::Set a_alone(FaceLabel l) const { return a_alone_ && l.b == none_ ? l.a : none_; }
  SourceSets::Set b_alone(FaceLabel l) const { return b_alone_ && l.a == none_ ? l.b : none_; }

  std::uint32_t lowest_of(const LabelSets& sets, FaceLabel l) const {
    if (l.a == none_ || !sets.a.contains(l.a, frame_)) return no_feature;
    if (const std::uint32_t i = sets.a.lowest(l.a); i < frame_) return i;
    if (l.b == none_ || (reach_ != no_feature && !sets.a.contains(l.a, reach_))) return no_feature;
    return sets.b.lowest(l.b);
  }

  Kind kind_;
  std::uint32_t frame_ = no_feature, reach_ = no_feature;  ///< of lowest: the two sources
  bool both_ = false, a_alone_ = false, b_alone_ = false;  ///< of pairs: which of them there are
};

}  // namespace oblast::internal
