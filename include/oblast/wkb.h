// Well-Known Binary of polygons: read and written.
//
//   byte order   1 byte: 0 big endian, 1 little endian; each geometry has its own
//   type         4 bytes: 3 polygon, 6 multipolygon, 7 collection; + 1000 Z, 2000 M, 3000 ZM (ISO 13249-3), or the bits
//                0x80000000 Z, 0x40000000 M, 0x20000000 SRID (EWKB of PostGIS)
//   SRID         4 bytes, where its bit is set
//   count        4 bytes: rings of a polygon, polygons of a multipolygon, geometries of a collection
//   a ring       4 bytes: count of points; then 2 to 4 doubles a point
#pragma once

#include <oblast/error.h>
#include <oblast/export.h>
#include <oblast/options.h>
#include <oblast/region_set.h>

#include <cstddef>
#include <span>
#include <vector>

namespace oblast {

/// The polygons of one geometry: a Polygon, a MultiPolygon, or a collection of these, up to 64 deep; any of them may be
/// empty. Rings come without their closing point; rings that are not closed are admitted. Z, M and the SRID are passed
/// over. An empty ring or polygon leaves nothing.
///
/// Counts are checked against the bytes that are there before anything is made of them, so memory is in proportion to
/// the bytes, whatever they say.
/// Throws Error, with Place::byte: bad_wkb for other types, bytes that are missing or left over, deeper nesting;
/// not_finite and out_of_domain, at the coordinate; bad_option, cancelled, memory_limit. Cost: linear.
OBLAST_API RegionSet read_wkb(std::span<const std::byte> bytes, const CallOptions& options = {});

/// Little endian: a Polygon where there is one, a MultiPolygon otherwise (also of none), its polygons in their order,
/// rings closed. What has no points is left out. Cost: linear.
/// Throws Error: bad_offsets, not_finite, out_of_domain, too_large; bad_option, cancelled, memory_limit.
OBLAST_API std::vector<std::byte> to_wkb(const RegionView& regions, const CallOptions& options = {});

}  // namespace oblast
