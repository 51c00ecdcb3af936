// Rows of regions in arrays, as Python sees them.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <oblast/features.h>
#include <oblast/region_set.h>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace oblast::python {

namespace nb = nanobind;

using Offsets = std::vector<std::uint32_t>;
using PointsIn = nb::ndarray<const double, nb::shape<-1, 2>, nb::c_contig, nb::device::cpu>;
using OffsetsIn = nb::ndarray<const std::int32_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

/// Row r has the polygons [row_offsets[r], row_offsets[r + 1]), a polygon its rings, a ring its points. Offsets begin
/// with 0, so the ends that the library reads are all but the first. What the spans view is kept alive by `keep_`: the
/// arrays of a result, those of a Python object, or an Arrow array. Objects of this class live in Python objects only,
/// so they end while the interpreter's lock is held.
class Arrays {
 public:
  std::span<const Point> points;
  std::span<const std::uint32_t> ring_offsets, polygon_offsets, row_offsets;

  std::size_t row_count() const { return row_offsets.size() - 1; }
  RegionView regions() const { return {points, ring_offsets.subspan(1), polygon_offsets.subspan(1)}; }
  FeatureView features() const { return {regions(), row_offsets.subspan(1)}; }
  /// The polygons of one row. REQUIRES: row < row_count().
  RegionView row(std::size_t row) const;
  /// The row that a ring belongs to; the last one if there are several without rings.
  std::size_t row_of_ring(std::size_t ring) const;

  /// Something that must live as long as the arrays.
  void keep(std::shared_ptr<const void> thing) { keep_.push_back(std::move(thing)); }
  /// Takes the vector over and returns a view of it.
  template <class T>
  std::span<const T> own(std::vector<T>&& values) {
    auto owned = std::make_shared<const std::vector<T>>(std::move(values));
    keep_.push_back(owned);
    return *owned;
  }

 private:
  std::vector<std::shared_ptr<const void>> keep_;
};

/// A result of the library. The points are not copied.
Arrays from_features(FeatureSet&& rows);
/// The same of a region set: one row.
Arrays from_region_set(RegionSet&& regions);
/// Arrays of Python, viewed. Throws nb::value_error if the offsets do not fit together.
Arrays from_numpy(const PointsIn& points, const OffsetsIn& rings, const OffsetsIn& polygons, const OffsetsIn& rows);
/// Throws nb::value_error unless offsets begin with 0, do not decrease and end with `count`.
void require_offsets(std::span<const std::uint32_t> offsets, std::size_t count, const char* name);
/// The given rows, copied. REQUIRES: all are below row_count().
Arrays take_rows(const Arrays& from, std::span<const std::int64_t> rows);

/// The rows of several, one after the other, copied. Throws Error(too_large).
Arrays concatenate(std::span<const Arrays* const> parts);

/// The same without the points that close rings. Copies only if there are any.
Arrays opened(const Arrays& rows);

void bind_arrays(nb::module_& module);

}  // namespace oblast::python
