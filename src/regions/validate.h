// Refusing bad arrays and bad coordinates, with the place.
#pragma once

#include <oblast/error.h>
#include <oblast/region_set.h>

#include <cstddef>
#include <span>
#include <string>

namespace oblast::internal {

/// Throws Error: bad_offsets, too_large, not_finite, out_of_domain. Cost: linear.
void validate(const RegionView& operand, std::size_t operand_index);

/// A coordinate that is not in the domain; `where` ends the message. Throws Error: not_finite, out_of_domain.
[[noreturn]] void throw_bad_coordinate(bool finite, const Place& place, const std::string& where = {});

/// The points of one contour. Throws Error: not_finite, out_of_domain, with the vertex. Cost: linear.
void validate(std::span<const Point> contour);

}  // namespace oblast::internal
