// Well-Known Text of polygons: read and written.
#pragma once

#include <oblast/error.h>
#include <oblast/export.h>
#include <oblast/options.h>
#include <oblast/region_set.h>

#include <string>
#include <string_view>

namespace oblast {

/// Reads the polygons of one geometry: a POLYGON, a MULTIPOLYGON, or a GEOMETRYCOLLECTION of these, nested up to 64
/// levels deep. Any of them may be EMPTY. Letters may be capital or small. The type may have the suffix Z, M or ZM
/// ("POLYGON Z" or "POLYGONZ"), and EWKT's "SRID=4326;" may stand before it. Z, M and the SRID are ignored. Without a
/// suffix the points of a geometry have two, three or four numbers, all alike. The closing point of a ring is removed;
/// a ring without one is accepted. Empty rings and empty polygons are left out. Each number becomes the nearest double.
///
/// Cost: linear. Throws Error, with Place::byte: bad_wkt if the text is anything else, or more text follows; not_finite
/// at nan or inf; out_of_domain at a number outside the domain, also one that is too large or too small for a double.
/// Throws Error without a place: too_large, bad_option, cancelled, memory_limit.
OBLAST_API RegionSet read_wkt(std::string_view text, const CallOptions& options = {});

/// Writes a POLYGON if there is exactly one polygon, otherwise a MULTIPOLYGON; "MULTIPOLYGON EMPTY" if there is none.
/// Rings are closed. Numbers have the fewest digits that read back to the same bits. Contours and polygons without
/// points are left out. Cost: linear.
/// Throws Error: bad_offsets, not_finite, out_of_domain, too_large; bad_option, cancelled, memory_limit.
OBLAST_API std::string to_wkt(const RegionView& regions, const CallOptions& options = {});

}  // namespace oblast
