// Well-Known Text of polygons: read and written.
#pragma once

#include <oblast/error.h>
#include <oblast/export.h>
#include <oblast/options.h>
#include <oblast/region_set.h>

#include <string>
#include <string_view>

namespace oblast {

/// The polygons of one geometry: POLYGON, MULTIPOLYGON, or GEOMETRYCOLLECTION of these, up to 64 deep, with Z, M or ZM
/// (also written onto the word: POLYGONZ), EMPTY, in capitals or not, with EWKT's "SRID=4326;" before it. Heights,
/// measures and the SRID are passed over; without Z or M too a point may have two to four numbers. Rings come without
/// their closing point; rings that are not closed are admitted. Numbers are the nearest doubles.
///
/// Throws Error, with Place::byte: bad_wkt where the text is something else, also past its end; not_finite (nan, inf,
/// what is too large for a double) and out_of_domain, at the number; bad_option, cancelled, memory_limit. Cost: linear.
OBLAST_API RegionSet read_wkt(std::string_view text, const CallOptions& options = {});

/// POLYGON where there is one, MULTIPOLYGON otherwise, "MULTIPOLYGON EMPTY" of none; rings closed. Numbers have the
/// fewest digits that read back to the same bits. What has no points is left out. Cost: linear.
/// Throws Error: bad_offsets, not_finite, out_of_domain, too_large; bad_option, cancelled, memory_limit.
OBLAST_API std::string to_wkt(const RegionView& regions, const CallOptions& options = {});

}  // namespace oblast
