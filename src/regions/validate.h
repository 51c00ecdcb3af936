// Refuses bad offsets and bad coordinates, with their place.
#pragma once

#include <oblast/error.h>
#include <oblast/region_set.h>

#include <cstddef>
#include <span>
#include <string>

namespace oblast::internal {

/// Throws Error: bad_offsets, too_large, not_finite, out_of_domain. Cost: linear.
void validate(const RegionView& operand, std::size_t operand_index);

/// Throws the error for a coordinate that is not in the domain: not_finite or out_of_domain. `where` ends the message.
[[noreturn]] void throw_bad_coordinate(bool finite, const Place& place, const std::string& where = {});

/// Checks the points of one contour. Throws Error: not_finite, out_of_domain, with the vertex. Cost: linear.
void validate(std::span<const Point> contour);

}  // namespace oblast::internal
