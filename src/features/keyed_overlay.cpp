#include "features/keyed_overlay.h"

#include <algorithm>

#include "base/parallel.h"
#include "base/stage_shares.h"
#include "features/borders.h"
#include "features/face_labels.h"
#include "features/rows.h"
#include "overlay/batches.h"
#include "overlay/pipeline.h"
#include "result/assemble.h"

namespace oblast::internal {
namespace {

/// What a batch leaves.
struct Batch {
  BatchRows rows;
  Array<std::uint32_t> sources, source_ends;  ///< as in KeyedResult

  std::span<const std::uint32_t> sources_of(std::uint32_t row) const {
    const std::uint32_t begin = row == 0 ? 0 : source_ends[row - 1];
    return std::span(sources).subspan(begin, source_ends[row] - begin);
  }
};

/// The least count of a source that is a member.
std::int32_t least(const FillRule& rule) { return rule.kind == FillRule::Kind::at_least ? rule.depth : 1; }

Borders border_stages(noding::Strands strands, const KeyedJob& job, LabelSets& sets, Statistics& statistics) {
  const Job noding{Operation::unite, job.options, job.control};
  const ChainGraph graph = node_stage(std::move(strands), noding, statistics);  // 2
  FaceLabels labels;
  {
    const InStage stage(Stage::label, label_share, job.control, statistics);
    labels = label_faces(graph, sets);  // 3
  }
  const InStage stage(Stage::select, select_share, job.control, statistics);
  return find_borders(graph, labels, sets, job.rule, job.options.collinear);  // 4
}

/// REQUIRES: the changes of the strands are handles of `strands.rules.sources`.
Batch run_batch(noding::Strands strands, const KeyedJob& job, Statistics& statistics) {
  LabelSets sets{SourceSets(least(job.options.fill_a)), SourceSets(least(job.options.fill_b))};
  const Borders borders = border_stages(std::move(strands), job, sets, statistics);
  const InStage stage(Stage::link, link_share, job.control, statistics);
  Batch batch;
  batch.rows = build_rows(borders, sets, job.rule, job.options.contours);  // 5, 6
  if (job.rule.is_set()) {
    for (const RowKey key : batch.rows.keys) {
      sets.a.for_each(feature_key(key).a, [&](std::uint32_t source) { batch.sources.push_back(source); });
      batch.source_ends.push_back(checked_index(batch.sources.size(), "sources of rows"));
    }
  }
  return batch;
}

/// The rows of all batches, numbered through: rows of different batches with one key are one row.
class RowNumbers {
 public:
  RowNumbers(const Array<Batch>& batches, bool by_sets) : batches_(batches), by_sets_(by_sets), of_(batches.size()) {
    Array<Row> rows;
    for (std::uint32_t b = 0; b < batches.size(); ++b) {
      of_[b].resize(batches[b].rows.keys.size());
      for (std::uint32_t r = 0; r < of_[b].size(); ++r) rows.push_back({batches[b].rows.keys[r], b, r});
    }
    parallel_sort(rows.begin(), rows.end(), [&](const Row& p, const Row& q) { return less(p, q); });
    for (const Row& row : rows) {
      if (first_.empty() || less(first_.back(), row)) first_.push_back(row);
      of_[row.batch][row.row] = static_cast<std::uint32_t>(first_.size() - 1);
    }
  }

  std::size_t size() const { return first_.size(); }
  std::uint32_t of(std::size_t batch, std::uint32_t row) const { return of_[batch][row]; }

  void write_names(KeyedResult& result) const {
    for (const Row& row : first_) {
      result.keys.push_back(row.key);
      if (!by_sets_) continue;
      const auto sources = batches_[row.batch].sources_of(row.row);
      result.sources.insert(result.sources.end(), sources.begin(), sources.end());
      result.source_ends.push_back(checked_index(result.sources.size(), "sources of rows"));
    }
  }

 private:
  struct Row {
    RowKey key;
    std::uint32_t batch, row;
  };

  bool less(const Row& p, const Row& q) const {
    if (!by_sets_) return p.key < q.key;
    return std::ranges::lexicographical_compare(batches_[p.batch].sources_of(p.row),
                                                batches_[q.batch].sources_of(q.row));
  }

  const Array<Batch>& batches_;
  bool by_sets_;
  Array<Array<std::uint32_t>> of_;  ///< by batch and row
  Array<Row> first_;                ///< by number: one of the rows
};

KeyedResult join_batches(Array<Batch> batches, const KeyedJob& job) {
  const RowNumbers numbers(batches, job.rule.is_set());
  KeyedResult result;
  numbers.write_names(result);
  Array<RegionSet> parts;
  PolygonRows rows;
  std::size_t bytes = 0;
  for (std::size_t b = 0; b < batches.size(); ++b) {
    BatchRows& batch = batches[b].rows;
    for (std::size_t i = 0; i < batch.regions.size(); ++i) {
      for (std::uint32_t& row : batch.rows[i]) row = numbers.of(b, row);
      bytes += bytes_of(batch.regions[i]);
      parts.push_back(std::move(batch.regions[i]));
      rows.of.push_back(std::move(batch.rows[i]));
    }
  }
  result.charge = Charge(bytes);
  result.regions = join(std::move(parts), {}, &rows);
  result.feature_ends.assign(numbers.size(), 0);
  for (const std::uint32_t row : rows.joined) ++result.feature_ends[row];
  std::uint32_t end = 0;
  for (std::uint32_t& e : result.feature_ends) e = end += e;
  return result;
}

}  // namespace

KeyedResult keyed_overlay(const KeyedJob& job, Statistics& statistics) {
  noding::Strands strands;
  {
    const InStage stage(Stage::collect, collect_share, job.control, statistics);
    strands = collect(job.operands, resolve_by_pipeline(job.control), statistics.resolved_polygons);  // 1
  }
  Array<Batch> batches;
  const auto begin = [&](std::size_t count) { batches.resize(count); };
  const auto run = [&](std::size_t i, noding::Strands batch, Statistics& done) {
    noding::SourceChanges changes(job.source_count);
    batch.rules.sources = &changes;
    batches[i] = run_batch(std::move(batch), job, done);
  };
  in_batches(std::move(strands), job.needs, job.control, statistics, {begin, run});
  const InStage stage(Stage::assemble, 1, job.control, statistics);
  return join_batches(std::move(batches), job);
}

KeyedResult keyed_overlay_of(noding::Strands strands, const KeyRule& rule, const Options& options, Control& control,
                             Statistics& statistics) {
  const KeyedJob job{{}, 0, rule, {}, options, control};
  Array<Batch> batches(1);
  batches[0] = run_batch(std::move(strands), job, statistics);
  const InStage stage(Stage::assemble, 1, job.control, statistics);
  return join_batches(std::move(batches), job);
}

}  // namespace oblast::internal
