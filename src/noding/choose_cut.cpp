#include "noding/choose_cut.h"

#include <algorithm>
#include <cstdint>

#include "base/tuning.h"
#include "plane/point_hash.h"

namespace oblast::internal::noding {
namespace {

constexpr std::size_t sample_size = tuning::cut_sample;

/// Judges a cut on the sample. `repeated` says how many edges of a run will be on both sides if the run is.
template <class Divide, class Repeated>
void judge(CellCut& cut, std::span<const Run* const> sample, const Divide& divide, const Repeated& repeated) {
  std::size_t left = 0, right = 0;
  std::uint32_t edges = 0, twice = 0;
  for (const Run* e : sample) {
    const Sides sides = divide(*e, cut);
    left += sides.left;
    right += sides.right;
    edges += e->last - e->first;
    if (sides.left && sides.right) twice += repeated(*e, cut);
  }
  const std::size_t most = sample.size() * 7 / 8;
  if (left <= most && right <= most) cut.growth = 1 + static_cast<double>(twice) / static_cast<double>(edges);
}

/// Entries drawn at random, the same ones each time: evenly spaced ones would follow the input's own rhythm.
class Sample {
 public:
  explicit Sample(std::span<const Run> runs) {
    std::uint64_t state = runs.size();
    for (const Run*& e : sample_) {
      state = mix(state + 0x9e3779b97f4a7c15ULL);
      e = &runs[((state >> 32) * runs.size()) >> 32];
    }
  }
  std::span<const Run* const> span() const { return sample_; }

  /// The median of the middles, which moves out of the boxes' own ends where it can.
  CellCut median_cut(CutKind kind) const {
    double middles[sample_size];
    for (std::size_t i = 0; i < sample_size; ++i)
      middles[i] = low(sample_[i]->box, kind) / 2 + high(sample_[i]->box, kind) / 2;
    std::nth_element(middles, middles + sample_size / 2, middles + sample_size);
    return {kind, middles[sample_size / 2]};
  }

 private:
  const Run* sample_[sample_size];
};

template <class Repeated>
CellCut best_axis_cut(const Sample& sample, const Repeated& repeated) {
  CellCut best;
  for (const CutKind kind : {CutKind::at_x, CutKind::at_y}) {
    CellCut cut = sample.median_cut(kind);
    judge(
        cut, sample.span(), [](const Run& e, const CellCut& c) { return divide_run({}, e, c); }, repeated);
    if (cut.growth < best.growth) best = cut;
  }
  return best;
}

}  // namespace

bool is_flat(const Run& run, Axis axis, const Box& cell, std::size_t count) {
  const Axis across = axis == Axis::x ? Axis::y : Axis::x;
  return (high(run.box, across) - low(run.box, across)) * static_cast<double>(count) <=
         high(cell, across) - low(cell, across);
}

CellCut best_run_cut(std::span<const Run> runs, RunParts parts) {
  return best_axis_cut(Sample(runs), [&](const Run& run, const CellCut&) {
    // To look where a run is divided would cost more than it tells: within one edge.
    return parts == RunParts::edges ? 1 : run.last - run.first;
  });
}

CellCut best_cut(std::span<const Point> points, std::span<const Run> runs, const Box& cell, bool may_part) {
  const auto divide = [&](const Run& e, const CellCut& c) { return divide_edge(points, e, c); };
  const Sample sample(runs);
  // Flat edges are copied until they cross a cell, which is soon.
  CellCut best = best_axis_cut(sample, [&](const Run& e, const CellCut& cut) {
    return is_flat(e, axis_of(cut.kind), cell, runs.size()) ? 0U : 1U;
  });
  const auto try_edges = [&](bool parts_touching) {
    for (std::size_t i = 0; i < sample_size; ++i) {
      if (best.growth <= tuning::good_growth ||
          (i >= tuning::cut_edges_tried && best.growth <= tuning::acceptable_growth))
        break;
      CellCut cut{CutKind::along_edge, 0, sample.span()[i]->first, parts_touching};
      judge(cut, sample.span(), divide, [](const Run&, const CellCut&) { return 1U; });
      if (cut.growth < best.growth) best = cut;
    }
  };
  const bool have_margins =
      std::any_of(sample.span().begin(), sample.span().end(), [](const Run* e) { return e->margin() > 0; });
  if (have_margins) try_edges(false);
  if (!have_margins || (may_part && best.growth > tuning::growth_worth_parting)) try_edges(true);
  return best;
}

}  // namespace oblast::internal::noding
