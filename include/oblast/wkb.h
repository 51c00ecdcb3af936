// Well-Known Binary of polygons: read and written.
//
//   byte order   1 byte: 0 big endian, 1 little endian; each geometry has its own
//   type         4 bytes: 3 polygon, 6 multipolygon, 7 collection; + 1000 Z, 2000 M, 3000 ZM (ISO 13249-3), or the bits
//                0x80000000 Z, 0x40000000 M, 0x20000000 SRID (EWKB of PostGIS)
//   SRID         4 bytes, if its bit is set
//   count        4 bytes: rings of a polygon, polygons of a multipolygon, geometries of a collection
//   a ring       4 bytes: count of points; then 2 to 4 doubles per point
#pragma once

#include <oblast/error.h>
#include <oblast/export.h>
#include <oblast/options.h>
#include <oblast/region_set.h>

#include <cstddef>
#include <span>
#include <vector>

namespace oblast {

/// Reads the polygons of one geometry: a Polygon, a MultiPolygon, or a GeometryCollection of these, nested up to 64
/// levels deep. Any of them may be empty. The closing point of a ring is removed; a ring without one is accepted. Z, M
/// and the SRID are ignored. Empty rings and empty polygons are left out.
///
/// A count is compared with the number of bytes that remain before it is used. So memory is proportional to the number
/// of bytes, even if counts are wrong. Cost: linear.
/// Throws Error, with Place::byte: bad_wkb for other types, missing or extra bytes, or deeper nesting; not_finite and
/// out_of_domain at the coordinate. Throws Error without a place: too_large, bad_option, cancelled, memory_limit.
OBLAST_API RegionSet read_wkb(std::span<const std::byte> bytes, const CallOptions& options = {});

/// Writes little-endian WKB: a Polygon if there is exactly one polygon, otherwise a MultiPolygon (also for no
/// polygons). Polygons keep their order, and rings are closed. Contours and polygons without points are left out. Cost:
/// linear.
/// Throws Error: bad_offsets, not_finite, out_of_domain, too_large; bad_option, cancelled, memory_limit.
OBLAST_API std::vector<std::byte> to_wkb(const RegionView& regions, const CallOptions& options = {});

}  // namespace oblast
