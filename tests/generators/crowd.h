// A crowd: hundreds of hostile cases of mixed generators side by side, with more edges than any threshold of the
// library.
//
// The result must have the bytes of each member alone, sorted: promises G3 and G7. A crowd costs little more than its
// members alone, so every case of a run can be in one.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generators/company.h"
#include "generators/request.h"

namespace oblast::generators {

struct CrowdMember {
  const HostileGenerator* generator = nullptr;
  std::uint64_t seed = 0;
  Operands operands;  ///< as the generator made them; put_in_places moves them
};

/// Two ways to place cases side by side. Neither keeps every bit, so a member alone is computed at its new place.
///   row    scaled to one size, in the cells of a grid: like a real layer, but the last few bits are rounded
///   scale  moved away from the axes, which rounds at most two bits, then scaled by separate powers of two in x and in
///          y, and mirrored: coordinates keep their bits, but have many magnitudes
enum class Places { row, scale };

/// Moves the members so that no box of one meets the box of another.
void put_in_places(std::vector<CrowdMember>& members, Places places);

struct CrowdFailure {
  std::size_t member;  ///< the member that differs
  std::string what;    ///< one line; for the first one, also the fewest members with which it differs, as WKT if short
};

/// Moves the members and runs a crowd of them: all four operations, and the union of all contours as one operand, each
/// with its polygons in a random order. `seed` decides fill rules, conventions, places, one or two threads, and
/// sometimes another engine. Returns every member that differs in the first of these that fails. `shrink`: whether to
/// make the first failure smaller, which takes up to a few minutes.
enum class Shrink { no, yes };
std::vector<CrowdFailure> run_crowd(std::vector<CrowdMember> members, std::uint64_t seed, Shrink shrink);

}  // namespace oblast::generators
