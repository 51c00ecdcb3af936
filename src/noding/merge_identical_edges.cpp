#include "noding/merge_identical_edges.h"

#include <algorithm>

#include "base/index.h"
#include "base/parallel.h"

namespace oblast::internal::noding {
namespace {

/// What is left of a range of strands: stretches without repeated edges, and the first of every identical ones.
class Remainder {
 public:
  Remainder(const Strands& strands, const IdenticalEdges& identical) : strands_(strands), identical_(identical) {}

  struct Size {
    std::size_t points = 0, strands = 0;
  };

  Size size(std::size_t first_strand, std::size_t past_strand) const {
    Size size;
    walk(first_strand, past_strand, [&](std::uint32_t first, std::uint32_t past, Winding, Group, Simplicity) {
      size.points += past - first;
      ++size.strands;
    });
    return size;
  }

  /// Writes it from `at` on. REQUIRES: there is room.
  void write(std::size_t first_strand, std::size_t past_strand, Size at, Strands& result) const {
    walk(first_strand, past_strand,
         [&](std::uint32_t first, std::uint32_t past, Winding change, Group group, Simplicity simplicity) {
           std::copy(strands_.points.begin() + first, strands_.points.begin() + past,
                     result.points.begin() + static_cast<std::ptrdiff_t>(at.points));
           at.points += past - first;
           result.ends[at.strands] = static_cast<std::uint32_t>(at.points);
           result.change[at.strands] = change;
           result.group[at.strands] = group;
           result.simplicity[at.strands] = simplicity;
           ++at.strands;
         });
  }

 private:
  bool is_repeated(std::uint32_t e) const { return identical_.first_of[e] != none; }

  /// Zero where the edge goes.
  Winding change_of(std::uint32_t e, std::size_t s) const {
    if (!is_repeated(e)) return strands_.change[s];
    return identical_.first_of[e] == e ? strands_.rules.reduce(identical_.sum[e]) : Winding{};
  }

  /// Calls strand(first vertex, past the last one, change, group, simplicity) for stretches of edges with one change.
  template <class Strand>
  void walk(std::size_t first_strand, std::size_t past_strand, const Strand& strand) const {
    for (std::size_t s = first_strand; s < past_strand; ++s) {
      const std::uint32_t begin = strands_.begin(s), past = strands_.ends[s] - 1;
      for (std::uint32_t first = begin, e; first < past; first = e) {
        const Winding change = change_of(first, s);
        for (e = first + 1; e < past && change_of(e, s) == change && is_repeated(e) == is_repeated(first);) ++e;
        if (change.is_zero()) continue;
        const bool whole = first == begin && e == past;
        strand(first, e + 1, change, strands_.group[s], whole ? strands_.simplicity[s] : Simplicity::known);
      }
    }
  }

  const Strands& strands_;
  const IdenticalEdges& identical_;
};

}  // namespace

Strands merge_identical_edges(Strands strands, const IdenticalEdges& identical) {
  if (identical.empty()) return strands;
  const Remainder remainder(strands, identical);
  const std::size_t strands_a_range = grain(strands.size(), strands.points.size());
  Array<Remainder::Size> ends(range_count(strands.size(), strands_a_range) + 1);
  for_numbered_ranges(strands.size(), strands_a_range, [&](std::size_t i, std::size_t first, std::size_t past) {
    ends[i + 1] = remainder.size(first, past);
  });
  for (std::size_t i = 1; i < ends.size(); ++i) {
    ends[i].points += ends[i - 1].points;
    ends[i].strands += ends[i - 1].strands;
  }
  // Where every second edge is repeated, each is a strand of its own.
  check_count(ends.back().points, "vertices of strands");
  Strands result;
  result.rules = strands.rules;
  result.resize(ends.back().points, ends.back().strands);
  for_numbered_ranges(strands.size(), strands_a_range, [&](std::size_t i, std::size_t first, std::size_t past) {
    remainder.write(first, past, ends[i], result);
  });
  return result;
}

}  // namespace oblast::internal::noding
