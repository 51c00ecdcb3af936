// Many small jobs, each of which gives a row: on all cores, in blocks, and joined in order.
#pragma once

#include <oblast/error.h>
#include <oblast/features.h>
#include <oblast/options.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace oblast::python {

/// Adds the polygons of a region set as one row.
void add_row(FeatureSet& rows, const RegionView& regions);
/// Adds rows of whole arrays: not of a part of larger ones.
void add_rows(FeatureSet& rows, const FeatureView& more);

/// An Error, and the job that threw it.
class JobError : public Error {
 public:
  JobError(const Error& error, std::size_t job) : Error(error), job_(job) {}
  std::size_t job() const { return job_; }

 private:
  std::size_t job_;
};

/// Runs `block(begin, end)` for parts of [0, count) on common.threads threads. Between parts it reports progress and
/// may be stopped. What a block throws is thrown here; of several, that of the smallest part.
void for_blocks(std::size_t count, const CallOptions& common,
                const std::function<void(std::size_t begin, std::size_t end)>& block);

/// One row for each of `count` jobs. `make_worker()` is called once for each part; the worker adds the row of a job.
using AddRow = std::function<void(std::size_t job, FeatureSet& rows)>;
FeatureSet collect_rows(std::size_t count, const CallOptions& common, const std::function<AddRow()>& make_worker);

}  // namespace oblast::python
