#include "overlay/independent_parts.h"

#include <algorithm>
#include <numeric>

#include "memory/large_pages.h"
#include "noding/cell_cut.h"
#include "overlay/disjoint_sets.h"

namespace oblast {
namespace {

using noding::Box;
using noding::Entry;
using noding::Strands;

constexpr std::uint32_t none = 0xffffffff;

// Fewer vertices are not worth dividing; a batch of this many has its arrays in the second-level cache.
constexpr std::size_t batch_vertices = 4000;
constexpr std::size_t leaf_size = 12;
// A cut that copies more than this separates nothing, and more work than this by strand is not worth it: then all
// boxes of the cell count as connected.
constexpr double largest_growth = 1.4;
constexpr std::size_t work_by_strand = 64;

/// The box of every strand, with the strand as its one edge.
std::vector<Entry> boxes_of(const Strands& strands) {
  std::vector<Entry> boxes(strands.size());
  for (std::uint32_t s = 0; s < strands.size(); ++s) {
    const std::uint32_t begin = strands.begin(s);
    Box box = Box::of(strands.points[begin], strands.points[begin]);
    for (std::uint32_t v = begin + 1; v < strands.ends[s]; ++v) {
      box = box.joined(strands.points[v]);
    }
    boxes[s] = {box, s, s + 1, noding::any_group};
  }
  return boxes;
}

/// Connects boxes that meet: cells are cut in two, as in the search for meetings (pair_finder.h), until few boxes are
/// left or all of a cell are known to be connected.
/// `order` becomes the strands in the order of the cells, so that neighbours in the plane are neighbours in memory.
DisjointSets connect(std::vector<Entry> entries, std::vector<std::uint32_t>& order) {
  DisjointSets sets(entries.size());
  std::vector<bool> placed(entries.size(), false);
  const auto leave = [&](std::size_t begin) {
    for (std::size_t i = begin; i < entries.size(); ++i) {
      if (!placed[entries[i].first]) order.push_back(entries[i].first);
      placed[entries[i].first] = true;
    }
    entries.resize(begin);
  };
  const std::size_t most_work = entries.size() * work_by_strand;
  std::size_t work = 0;
  std::vector<Entry> right;
  std::vector<std::size_t> stack{0};  // cells, depth first: the one on top owns the tail of `entries`
  while (!stack.empty()) {
    const std::size_t begin = stack.back();
    stack.pop_back();
    const std::span<const Entry> cell = std::span(entries).subspan(begin);
    work += cell.size();
    const bool connected = std::all_of(cell.begin(), cell.end(),
                                       [&](const Entry& e) { return sets.find(e.first) == sets.find(cell[0].first); });
    if (connected) {
      leave(begin);
      continue;
    }
    if (cell.size() <= leaf_size) {
      for (std::size_t i = 0; i < cell.size(); ++i)
        for (std::size_t j = i + 1; j < cell.size(); ++j)
          if (cell[i].box.meets(cell[j].box)) sets.unite(cell[i].first, cell[j].first);
      leave(begin);
      continue;
    }
    const noding::CellCut cut = noding::best_run_cut(cell, noding::RunParts::whole);
    if (cut.growth > largest_growth || work > most_work) {
      for (const Entry& e : cell) sets.unite(cell[0].first, e.first);
      leave(begin);
      continue;
    }
    right.clear();
    std::size_t left_end = begin;
    for (std::size_t i = begin; i < entries.size(); ++i) {
      const Entry e = entries[i];
      const noding::Sides sides = noding::divide_run({}, e, cut);
      if (sides.right) right.push_back(e);
      if (sides.left) entries[left_end++] = e;
    }
    entries.resize(left_end);
    entries.insert(entries.end(), right.begin(), right.end());
    stack.push_back(begin);
    stack.push_back(left_end);
  }
  return sets;
}

}  // namespace

bool worth_dividing(const Strands& strands) { return strands.points.size() > batch_vertices && strands.size() > 1; }

IndependentParts independent_parts(const Strands& strands, PartNeeds needs) {
  IndependentParts parts;
  const auto count = static_cast<std::uint32_t>(strands.size());
  if (!worth_dividing(strands)) {
    parts.strands.resize(count);
    std::iota(parts.strands.begin(), parts.strands.end(), 0U);
    parts.ends = {count};
    return parts;
  }

  std::vector<std::uint32_t> order;
  order.reserve(count);
  DisjointSets sets = connect(boxes_of(strands), order);
  struct Part {
    std::uint32_t vertices = 0;
    bool a = false, b = false;
    std::uint32_t batch = none;
  };
  std::vector<Part> part(count);  // by root
  for (std::uint32_t s = 0; s < count; ++s) {
    Part& p = part[sets.find(s)];
    p.vertices += strands.ends[s] - strands.begin(s);
    p.a |= strands.change[s].a != 0;
    p.b |= strands.change[s].b != 0;
  }

  // Small parts of one batch are taken as the strands come, not as they lie: far from each other, they do not disturb
  // each other's sweeps.
  std::vector<std::uint32_t> size;  // by batch: its strands
  std::size_t filled = batch_vertices;
  for (std::uint32_t s = 0; s < count; ++s) {
    Part& p = part[sets.find(s)];
    if ((needs.a && !p.a) || (needs.b && !p.b)) continue;
    if (p.batch == none) {
      if (filled >= batch_vertices) {
        size.push_back(0);
        filled = 0;
      }
      filled += p.vertices;
      p.batch = static_cast<std::uint32_t>(size.size() - 1);
    }
    ++size[p.batch];
  }

  parts.ends.resize(size.size());
  std::exclusive_scan(size.begin(), size.end(), parts.ends.begin(), 0U);
  parts.strands.resize(std::accumulate(size.begin(), size.end(), 0U));
  // ends[b] moves from the beginning of the batch to its end as the batch fills.
  for (const std::uint32_t s : order) {
    const std::uint32_t batch = part[sets.find(s)].batch;
    if (batch != none) parts.strands[parts.ends[batch]++] = s;
  }
  return parts;
}

Strands batch_of(const Strands& strands, const IndependentParts& parts, std::size_t batch) {
  const auto begin = parts.strands.begin() + (batch == 0 ? 0 : parts.ends[batch - 1]);
  const auto end = parts.strands.begin() + parts.ends[batch];
  Strands part;
  part.parity = strands.parity;
  std::size_t vertices = 0;
  for (auto s = begin; s != end; ++s) vertices += strands.ends[*s] - strands.begin(*s);
  reserve_in_large_pages(part.points, vertices);
  for (auto s = begin; s != end; ++s) {
    part.points.insert(part.points.end(), strands.points.begin() + strands.begin(*s),
                       strands.points.begin() + strands.ends[*s]);
    part.close_strand(strands.change[*s], strands.group[*s], strands.simplicity[*s]);
  }
  return part;
}

Strands only_batch(Strands strands, const IndependentParts& parts, std::size_t batch) {
  std::vector<bool> kept(strands.size(), false);
  for (std::uint32_t i = batch == 0 ? 0 : parts.ends[batch - 1]; i < parts.ends[batch]; ++i)
    kept[parts.strands[i]] = true;
  std::uint32_t count = 0, size = 0, begin = 0;
  for (std::size_t s = 0; s < kept.size(); ++s) {
    const std::uint32_t end = strands.ends[s];
    if (kept[s]) {
      std::copy(strands.points.begin() + begin, strands.points.begin() + end, strands.points.begin() + size);
      size += end - begin;
      strands.ends[count] = size;
      strands.change[count] = strands.change[s];
      strands.group[count] = strands.group[s];
      strands.simplicity[count++] = strands.simplicity[s];
    }
    begin = end;
  }
  strands.points.resize(size);
  strands.ends.resize(count);
  strands.change.resize(count);
  strands.group.resize(count);
  strands.simplicity.resize(count);
  return strands;
}

}  // namespace oblast
