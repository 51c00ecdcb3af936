#include "blocks.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <span>

namespace oblast::python {

namespace {

constexpr std::size_t block_size = 256;

std::uint32_t index_of(std::size_t count) {
  if (count > std::numeric_limits<std::int32_t>::max())
    throw Error(ErrorCode::too_large, "the result has more than 2^31 - 1 vertices");
  return static_cast<std::uint32_t>(count);
}

/// The parts that are done, and the first fault.
class Blocks {
 public:
  Blocks(std::size_t count, const CallOptions& common) : count_(count), common_(common) {}

  void run(std::size_t index, const std::function<void(std::size_t, std::size_t)>& block) {
    if (failed_) return;
    const std::size_t begin = index * block_size, end = std::min(count_, begin + block_size);
    try {
      block(begin, end);
      done_ += end - begin;
      const double fraction = static_cast<double>(done_) / static_cast<double>(count_);
      if (common_.progress && !common_.progress(Stage::collect, fraction))
        throw Error(ErrorCode::cancelled, "the call was cancelled");
    } catch (...) {
      note(index);
    }
  }
  void rethrow() const {
    if (fault_) std::rethrow_exception(fault_);
  }

 private:
  void note(std::size_t index) {
    const std::lock_guard lock(mutex_);
    if (index < faulty_) fault_ = std::current_exception(), faulty_ = index;
    failed_ = true;
  }

  std::size_t count_;
  const CallOptions& common_;
  std::atomic<std::size_t> done_ = 0;
  std::atomic<bool> failed_ = false;
  std::mutex mutex_;
  std::exception_ptr fault_;
  std::size_t faulty_ = std::numeric_limits<std::size_t>::max();
};

}  // namespace

void add_row(FeatureSet& rows, const RegionView& regions) {
  RegionSet& all = rows.regions;
  const std::uint32_t points =
      index_of(all.points.size() + regions.points.size()) - static_cast<std::uint32_t>(regions.points.size());
  const auto rings = static_cast<std::uint32_t>(all.contour_ends.size());
  all.points.insert(all.points.end(), regions.points.begin(), regions.points.end());
  for (std::size_t c = 0; c < regions.contour_count(); ++c) all.contour_ends.push_back(points + regions.contour_end(c));
  for (std::size_t p = 0; p < regions.polygon_count(); ++p) all.polygon_ends.push_back(rings + regions.polygon_end(p));
  rows.feature_ends.push_back(static_cast<std::uint32_t>(all.polygon_ends.size()));
}

void add_rows(FeatureSet& rows, const FeatureView& more) {
  const auto append = [](std::vector<std::uint32_t>& ends, std::span<const std::uint32_t> others, std::size_t by) {
    for (const std::uint32_t end : others) ends.push_back(end + static_cast<std::uint32_t>(by));
  };
  RegionSet& all = rows.regions;
  index_of(all.points.size() + more.regions.points.size());
  append(rows.feature_ends, more.feature_ends, all.polygon_ends.size());
  append(all.polygon_ends, more.regions.polygon_ends, all.contour_ends.size());
  append(all.contour_ends, more.regions.contour_ends, all.points.size());
  all.points.insert(all.points.end(), more.regions.points.begin(), more.regions.points.end());
}

void for_blocks(std::size_t count, const CallOptions& common,
                const std::function<void(std::size_t, std::size_t)>& block) {
  Blocks blocks(count, common);
  const std::size_t block_count = (count + block_size - 1) / block_size;
  if (common.threads == 1 || block_count <= 1) {
    for (std::size_t i = 0; i < block_count; ++i) blocks.run(i, block);
  } else {
    tbb::task_arena arena(common.threads == 0 ? tbb::task_arena::automatic : common.threads);
    arena.execute(
        [&] { tbb::parallel_for(std::size_t{0}, block_count, [&](std::size_t i) { blocks.run(i, block); }); });
  }
  blocks.rethrow();
}

FeatureSet collect_rows(std::size_t count, const CallOptions& common, const std::function<AddRow()>& make_worker) {
  std::vector<FeatureSet> parts((count + block_size - 1) / block_size);
  for_blocks(count, common, [&](std::size_t begin, std::size_t end) {
    const AddRow add = make_worker();
    FeatureSet& rows = parts[begin / block_size];
    for (std::size_t job = begin; job < end; ++job) {
      try {
        add(job, rows);
      } catch (const Error& error) {
        throw JobError(error, job);
      }
    }
  });
  if (parts.size() == 1) return std::move(parts.front());
  FeatureSet all;
  std::size_t points = 0;
  for (const FeatureSet& part : parts) points += part.regions.points.size();
  all.regions.points.reserve(points);
  all.feature_ends.reserve(count);
  for (FeatureSet& part : parts) {
    add_rows(all, part);
    part = {};
  }
  return all;
}

}  // namespace oblast::python
