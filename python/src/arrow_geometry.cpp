#include "arrow_geometry.h"

#include <limits>

#include "wkb.h"

namespace oblast::python {

namespace {

/// Offsets of a list array, from its own offset on, as they are: they may begin with any number.
Offsets offsets_of(const ArrowArray& array, bool large) {
  const auto count = static_cast<std::size_t>(array.length);
  Offsets offsets(count + 1, 0);
  if (count == 0 || array.buffers[1] == nullptr) return offsets;
  if (!large) {
    const auto* from = static_cast<const std::int32_t*>(array.buffers[1]) + array.offset;
    for (std::size_t i = 0; i <= count; ++i) offsets[i] = static_cast<std::uint32_t>(from[i]);
  } else {
    const auto* from = static_cast<const std::int64_t*>(array.buffers[1]) + array.offset;
    for (std::size_t i = 0; i <= count; ++i) {
      if (from[i] > std::numeric_limits<std::int32_t>::max()) throw Error(ErrorCode::too_large, "too many vertices");
      offsets[i] = static_cast<std::uint32_t>(from[i]);
    }
  }
  return offsets;
}

bool is_null(const ArrowArray& array, std::size_t index) {
  if (array.null_count == 0 || array.n_buffers == 0 || array.buffers[0] == nullptr) return false;
  const std::size_t bit = index + static_cast<std::size_t>(array.offset);
  return (static_cast<const std::uint8_t*>(array.buffers[0])[bit / 8] >> (bit % 8) & 1) == 0;
}

/// The offsets of the lists in [from, to) of a level, counted from the first item that is used.
/// Sets [from, to) to the items of the level below.
Offsets level_offsets(const ArrowArray& level, bool large, std::size_t& from, std::size_t& to) {
  ArrowArray part = level;
  part.offset += static_cast<std::int64_t>(from);
  part.length = static_cast<std::int64_t>(to - from);
  Offsets offsets = offsets_of(part, large);
  from = offsets.front();
  to = offsets.back();
  for (std::uint32_t& offset : offsets) offset -= static_cast<std::uint32_t>(from);
  return offsets;
}

std::span<const Point> interleaved_points(const ArrowArray& list, std::size_t from, std::size_t to, int dimensions,
                                          Arrays& keep) {
  const ArrowArray& numbers = *list.children[0];
  const auto width = static_cast<std::size_t>(dimensions);
  const auto* data = static_cast<const double*>(numbers.buffers[1]) + numbers.offset +
                     (static_cast<std::size_t>(list.offset) + from) * width;
  if (dimensions == 2) return {reinterpret_cast<const Point*>(data), to - from};
  std::vector<Point> points(to - from);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = {data[width * i], data[width * i + 1]};
  return keep.own(std::move(points));
}

std::span<const Point> separate_points(const ArrowArray& record, std::size_t from, std::size_t to, Arrays& keep) {
  const auto numbers = [&](int axis) {
    const ArrowArray& column = *record.children[axis];
    return static_cast<const double*>(column.buffers[1]) + column.offset + record.offset;
  };
  const double *x = numbers(0), *y = numbers(1);
  std::vector<Point> points(to - from);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = {x[from + i], y[from + i]};
  return keep.own(std::move(points));
}

// Polygons without rings are left out, as in all results; `kept` counts those before.
void drop_empty(Offsets& polygons, Offsets& rows) {
  Offsets kept_polygons{0}, kept(polygons.size(), 0);
  for (std::size_t p = 0; p + 1 < polygons.size(); ++p) {
    if (polygons[p + 1] != polygons[p]) kept_polygons.push_back(polygons[p + 1]);
    kept[p + 1] = static_cast<std::uint32_t>(kept_polygons.size() - 1);
  }
  for (std::uint32_t& row : rows) row = kept[row];
  polygons = std::move(kept_polygons);
}

// Rows that are null but have items lose them.
Arrays without_nulls(Arrays rows, const ArrowArray& array) {
  bool any = false;
  for (std::size_t r = 0; r < rows.row_count() && !any; ++r) any = is_null(array, r) && !rows.row(r).points.empty();
  if (!any) return rows;
  std::vector<std::int64_t> taken;
  for (std::size_t r = 0; r < rows.row_count(); ++r)
    if (!is_null(array, r)) taken.push_back(static_cast<std::int64_t>(r));
  Arrays compact = take_rows(rows, taken);
  Offsets offsets{0};
  std::size_t next = 0;
  for (std::size_t r = 0; r < rows.row_count(); ++r)
    offsets.push_back(is_null(array, r) ? offsets.back() : compact.row_offsets[++next]);
  compact.row_offsets = compact.own(std::move(offsets));
  return compact;
}

Arrays nested_rows(const ArrowArray& array, const ArrowOwner& owner, const GeometryColumn& column) {
  Arrays rows;
  rows.keep(owner);
  std::size_t from = 0, to = static_cast<std::size_t>(array.length), depth = 0;
  const ArrowArray* level = &array;
  const auto next = [&] {
    Offsets offsets = level_offsets(*level, column.large_lists[depth++], from, to);
    level = level->children[0];
    return offsets;
  };
  Offsets row_offsets;
  if (column.encoding == Encoding::multipolygon) {
    row_offsets = next();
  } else {
    for (std::uint32_t r = 0; r <= array.length; ++r) row_offsets.push_back(r);
  }
  Offsets polygons = next();
  Offsets rings = next();
  drop_empty(polygons, row_offsets);
  rows.points = column.interleaved ? interleaved_points(*level, from, to, column.dimensions, rows)
                                   : separate_points(*level, from, to, rows);
  rows.ring_offsets = rows.own(std::move(rings));
  rows.polygon_offsets = rows.own(std::move(polygons));
  rows.row_offsets = rows.own(std::move(row_offsets));
  require_offsets(rows.ring_offsets, rows.points.size(), "the offsets of rings");
  require_offsets(rows.polygon_offsets, rows.ring_offsets.size() - 1, "the offsets of polygons");
  require_offsets(rows.row_offsets, rows.polygon_offsets.size() - 1, "the offsets of rows");
  return without_nulls(std::move(rows), array);
}

Arrays wkb_rows(const ArrowArray& array, bool large, const Settings& settings, bool& has_z) {
  const auto* data = static_cast<const std::byte*>(array.buffers[2]);
  const auto offset = [&](std::int64_t i) {
    i += array.offset;
    return large ? static_cast<const std::int64_t*>(array.buffers[1])[i]
                 : static_cast<std::int64_t>(static_cast<const std::int32_t*>(array.buffers[1])[i]);
  };
  std::vector<Wkb> geometries(static_cast<std::size_t>(array.length));
  for (std::int64_t i = 0; i < array.length; ++i)
    if (!is_null(array, static_cast<std::size_t>(i)))
      geometries[static_cast<std::size_t>(i)] = {data + offset(i), static_cast<std::size_t>(offset(i + 1) - offset(i))};
  return from_features(read_rows(geometries, settings, has_z));
}

}  // namespace

Arrays rows_of_chunk(const ArrowOwner& chunk, const GeometryColumn& column, const Settings& settings, bool& has_z) {
  ArrowArray array = *chunk;
  if (column.child >= 0) {
    array = *chunk->children[column.child];
    array.offset += chunk->offset;
    array.length = chunk->length;
    if (chunk->offset != 0) array.null_count = -1;
  }
  if (column.encoding == Encoding::wkb) return wkb_rows(array, column.large, settings, has_z);
  has_z = has_z || column.dimensions > 2;
  return nested_rows(array, chunk, column);
}

}  // namespace oblast::python
