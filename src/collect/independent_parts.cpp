#include "collect/independent_parts.h"

#include <algorithm>
#include <numeric>

#include "base/counting_sort.h"
#include "base/index.h"
#include "base/large_pages.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "plane/connected_boxes.h"

namespace oblast::internal {
namespace {

using noding::Strands;

LargeArray<Box> boxes_of(const Strands& strands) {
  LargeArray<Box> boxes;
  resize_uninitialized(boxes, strands.size());
  for_ranges(strands.size(), grain(strands.size(), strands.points.size()), [&](std::size_t first, std::size_t past) {
    for (std::size_t s = first; s < past; ++s) {
      const Point& p = strands.points[strands.begin(s)];
      Box box = Box::of(p, p);
      for (std::uint32_t v = strands.begin(s) + 1; v < strands.ends[s]; ++v) box = box.joined(strands.points[v]);
      boxes[s] = box;
    }
  });
  return boxes;
}

}  // namespace

bool worth_dividing(const Strands& strands) {
  return strands.points.size() > tuning::batch_vertices && strands.size() > 1;
}

IndependentParts independent_parts(const Strands& strands, PartNeeds needs) {
  IndependentParts parts;
  const auto count = static_cast<std::uint32_t>(strands.size());
  if (!worth_dividing(strands)) {
    parts.strands.resize(count);
    std::iota(parts.strands.begin(), parts.strands.end(), 0U);
    parts.ends = {count};
    return parts;
  }

  const ConnectedBoxes connected = connected_boxes(boxes_of(strands));
  struct Part {
    std::uint32_t vertices = 0;
    bool a = false, b = false;
    std::uint32_t batch = none;
  };
  Array<Part> part(count);  // by component
  Steps steps(std::size_t{2} * count);
  for (std::uint32_t s = 0; s < count; ++s) {
    steps();
    Part& p = part[connected.component[s]];
    p.vertices += strands.ends[s] - strands.begin(s);
    p.a |= strands.change[s].a != 0;
    p.b |= strands.change[s].b != 0;
  }

  // Small parts of one batch are taken as the strands come, not as they lie: far from each other, they do not disturb
  // each other's sweeps.
  std::uint32_t batches = 0;
  std::size_t filled = tuning::batch_vertices;
  for (std::uint32_t s = 0; s < count; ++s) {
    steps();
    Part& p = part[connected.component[s]];
    if ((needs.a && !p.a) || (needs.b && !p.b)) continue;
    if (p.batch != none) continue;
    if (filled >= tuning::batch_vertices) {
      ++batches;
      filled = 0;
    }
    filled += p.vertices;
    p.batch = batches - 1;
  }

  parts.ends.resize(batches);
  counting_sort(parts.ends, parts.strands, [&](const auto& visit) {
    for (const std::uint32_t s : connected.order)
      if (const std::uint32_t batch = part[connected.component[s]].batch; batch != none) visit(batch, s);
  });
  return parts;
}

Strands batch_of(const Strands& strands, const IndependentParts& parts, std::size_t batch) {
  const auto begin = parts.strands.begin() + (batch == 0 ? 0 : parts.ends[batch - 1]);
  const auto end = parts.strands.begin() + parts.ends[batch];
  Strands part;
  part.rules = strands.rules;
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
  Array<bool> kept(strands.size(), false);
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
  strands.resize(size, count);
  return strands;
}

}  // namespace oblast::internal
