#include <oblast/c.h>
#include <oblast/oblast.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <new>
#include <optional>

struct oblast_options {
  oblast::Options options;
  std::optional<oblast::Workspace> workspace;
};

struct oblast_regions {
  oblast::RegionSet set;
};

namespace {

using oblast::ErrorCode;

static_assert(sizeof(oblast::Point) == 2 * sizeof(double));
static_assert(static_cast<int>(oblast::Operation::symmetric_difference) == OBLAST_SYMMETRIC_DIFFERENCE);
static_assert(static_cast<int>(oblast::FillRule::Kind::negative) == OBLAST_FILL_NEGATIVE);

oblast_status status_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::not_finite:
      return OBLAST_NOT_FINITE;
    case ErrorCode::out_of_domain:
      return OBLAST_OUT_OF_DOMAIN;
    case ErrorCode::too_large:
      return OBLAST_TOO_LARGE;
    case ErrorCode::bad_offsets:
      return OBLAST_BAD_OFFSETS;
    case ErrorCode::bad_option:
      return OBLAST_BAD_OPTION;
    case ErrorCode::precondition:
      return OBLAST_PRECONDITION;
    case ErrorCode::cancelled:
      return OBLAST_CANCELLED;
    case ErrorCode::memory_limit:
      return OBLAST_MEMORY_LIMIT;
    default:
      return OBLAST_UNKNOWN;
  }
}

oblast_status report(oblast_error* error, oblast_status status, const char* message, const oblast::Place& place = {}) {
  if (!error) return status;
  *error = {status, place.operand, place.polygon, place.contour, place.vertex, {}};
  std::strncpy(error->message, message, sizeof error->message - 1);
  return status;
}

/// Runs work() and converts an exception into a status.
template <class Work>
oblast_status guarded(oblast_error* error, const Work& work) noexcept {
  try {
    work();
    if (error) *error = {OBLAST_OK, SIZE_MAX, SIZE_MAX, SIZE_MAX, SIZE_MAX, {}};
    return OBLAST_OK;
  } catch (const oblast::Error& e) {
    return report(error, status_of(e.code()), e.what(), e.place());
  } catch (const std::bad_alloc&) {
    return report(error, OBLAST_OUT_OF_MEMORY, "the system has no more memory");
  } catch (const std::exception& e) {
    return report(error, OBLAST_UNKNOWN, e.what());
  } catch (...) {
    return report(error, OBLAST_UNKNOWN, "an unknown exception was thrown");
  }
}

bool is_whole(const oblast_view& v) {
  return (v.points || v.point_count == 0) && (v.contour_ends || v.contour_count == 0) &&
         (v.polygon_ends || v.polygon_count == 0);
}

oblast::RegionView view_of(const oblast_view& v) {
  oblast::RegionView view;
  view.points = {reinterpret_cast<const oblast::Point*>(v.points), v.point_count};
  view.contour_ends = {v.contour_ends, v.contour_count};
  view.polygon_ends = {v.polygon_ends, v.polygon_count};
  return view;
}

oblast::Options options_of(const oblast_options* options) { return options ? options->options : oblast::Options{}; }

/// Checks the pointers, and makes a region set of what `work` returns.
template <class Work>
oblast_status make_regions(bool whole, oblast_regions** result, oblast_error* error, const Work& work) noexcept {
  if (!result) return report(error, OBLAST_NULL_POINTER, "result is NULL");
  *result = nullptr;
  if (!whole) return report(error, OBLAST_NULL_POINTER, "a view, or an array of a view, is NULL");
  return guarded(error, [&] {
    auto made = std::make_unique<oblast_regions>();
    made->set = work();
    *result = made.release();
  });
}

}  // namespace

int oblast_version(void) { return OBLAST_VERSION_NUMBER; }

oblast_options* oblast_options_new(void) { return new (std::nothrow) oblast_options; }
void oblast_options_free(oblast_options* options) { delete options; }
void oblast_options_set_threads(oblast_options* options, int threads) { options->options.threads = threads; }
void oblast_options_set_memory(oblast_options* options, size_t most_bytes) { options->options.most_bytes = most_bytes; }

void oblast_options_set_progress(oblast_options* options, oblast_progress progress, void* data) {
  options->options.progress = nullptr;
  if (progress)
    options->options.progress = [=](oblast::Stage, double fraction) { return progress(fraction, data) != 0; };
}

void oblast_options_set_fill(oblast_options* options, int operand, int fill, int32_t depth) {
  (operand == 0 ? options->options.fill_a : options->options.fill_b) = {static_cast<oblast::FillRule::Kind>(fill),
                                                                        fill == OBLAST_FILL_AT_LEAST ? depth : 1};
}

void oblast_options_set_minimal(oblast_options* options, int minimal) {
  options->options.collinear = minimal ? oblast::CollinearVertices::drop : oblast::CollinearVertices::keep;
}

void oblast_options_set_workspace(oblast_options* options, int keep) {
  options->workspace.reset();
  options->options.workspace = nullptr;
  if (!keep) return;
  try {
    options->workspace.emplace();
    options->options.workspace = &*options->workspace;
  } catch (...) {  // calls then work without a workspace
  }
}

oblast_status oblast_overlay(const oblast_view* a, const oblast_view* b, int operation, const oblast_options* options,
                             oblast_regions** result, oblast_error* error) {
  return make_regions(a && b && is_whole(*a) && is_whole(*b), result, error, [&] {
    return oblast::overlay(view_of(*a), view_of(*b), static_cast<oblast::Operation>(operation), options_of(options));
  });
}

oblast_status oblast_unite(const oblast_view* a, const oblast_options* options, oblast_regions** result,
                           oblast_error* error) {
  return make_regions(a && is_whole(*a), result, error,
                      [&] { return oblast::unite(view_of(*a), options_of(options)); });
}

oblast_view oblast_regions_view(const oblast_regions* regions) {
  if (!regions) return {nullptr, 0, nullptr, 0, nullptr, 0};
  const oblast::RegionSet& set = regions->set;
  return {reinterpret_cast<const double*>(set.points.data()),
          set.points.size(),
          set.contour_ends.data(),
          set.contour_ends.size(),
          set.polygon_ends.data(),
          set.polygon_ends.size()};
}

void oblast_regions_free(oblast_regions* regions) { delete regions; }

double oblast_signed_area(const oblast_view* a, oblast_error* error) {
  double area = 0;
  if (!a || !is_whole(*a))
    report(error, OBLAST_NULL_POINTER, "the view, or an array of it, is NULL");
  else
    guarded(error, [&] { area = oblast::signed_area(view_of(*a)); });
  return area;
}
