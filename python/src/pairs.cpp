// Overlays of many pairs of rows, on all cores.
#include <oblast/overlay.h>
#include <oblast/workspace.h>

#include <atomic>
#include <memory>
#include <optional>

#include "bindings.h"
#include "blocks.h"
#include "call.h"

namespace oblast::python {

namespace {

using Indices = nb::ndarray<const std::int64_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

// A pair with more vertices may take so long that it must be stopped inside.
constexpr std::size_t least_stopped_vertices = 500;

void require_below(const Indices& indices, std::size_t count, const char* name) {
  for (std::size_t k = 0; k < indices.shape(0); ++k)
    if (indices.data()[k] < 0 || static_cast<std::size_t>(indices.data()[k]) >= count)
      throw nb::index_error((std::string(name) + "[" + std::to_string(k) + "] is " + std::to_string(indices.data()[k]) +
                             ", but there are " + std::to_string(count) + " rows")
                                .c_str());
}

/// What one thread keeps between the pairs of a part.
struct Pair {
  Workspace workspace;
  RegionSet result;
};

AddRow pair_worker(const Arrays& a, const Arrays& b, const std::int64_t* i, const std::int64_t* j, Operation operation,
                   const Options& options) {
  const auto kept = std::make_shared<Pair>();
  return [&a, &b, i, j, operation, &options, kept](std::size_t k, FeatureSet& rows) {
    const RegionView va = a.row(static_cast<std::size_t>(i[k])), vb = b.row(static_cast<std::size_t>(j[k]));
    Options own = options;
    own.threads = 1;
    own.workspace = &kept->workspace;
    if (va.points.size() + vb.points.size() < least_stopped_vertices)
      own.progress = {};
    else if (options.progress)  // only whether to stop: the fraction is that of one pair
      own.progress = [&options](Stage stage, double) { return options.progress(stage, 0); };
    overlay(va, vb, operation, own, kept->result);
    add_row(rows, kept->result);
  };
}

Arrays overlay_pairs(const Arrays& a, const Arrays& b, const Indices& i, const Indices& j, int operation,
                     const Settings& settings) {
  if (i.shape(0) != j.shape(0)) throw nb::value_error("i and j must have the same length");
  require_below(i, a.row_count(), "i");
  require_below(j, b.row_count(), "j");
  FeatureSet rows;
  std::size_t faulty = Place::npos;
  std::optional<Error> fault;
  run(settings, {&a, &b}, [&](const CallOptions& common) {
    Options options = settings.with(common);
    options.statistics = nullptr;  // pairs run side by side
    try {
      rows = collect_rows(i.shape(0), common, [&] {
        return pair_worker(a, b, i.data(), j.data(), static_cast<Operation>(operation), options);
      });
    } catch (const JobError& error) {
      fault = error;
      faulty = error.job();
    }
  });
  if (fault) {
    const std::int64_t* const index = fault->place().operand == 1 ? j.data() : i.data();
    raise_error(*fault, {}, static_cast<std::size_t>(index[faulty]));
  }
  return from_features(std::move(rows));
}

}  // namespace

void bind_pairs(nb::module_& module) {
  module.def("overlay_pairs", &overlay_pairs, nb::arg("a"), nb::arg("b"), nb::arg("i"), nb::arg("j"),
             nb::arg("operation"), nb::arg("settings"),
             nb::sig("def overlay_pairs(a: Arrays, b: Arrays, i: numpy.typing.NDArray[numpy.int64], "
                     "j: numpy.typing.NDArray[numpy.int64], operation: int, settings: Settings) -> Arrays"));
}

}  // namespace oblast::python
