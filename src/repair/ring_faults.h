// Faults that two edges show: rings that cross, touch or run along themselves and each other.
#pragma once

#include <oblast/region_set.h>
#include <oblast/repair.h>

#include <cstdint>

namespace oblast::internal::repairing {

/// RepairFaults as bits.
class FaultSet {
 public:
  void add(RepairFault fault) { bits_ |= bit_of(fault); }
  void add(FaultSet faults) { bits_ |= faults.bits_; }
  void remove(RepairFault fault) { bits_ &= ~bit_of(fault); }
  bool has(RepairFault fault) const { return (bits_ & bit_of(fault)) != 0; }
  bool empty() const { return bits_ == 0; }

  static std::uint32_t bit_of(RepairFault fault) { return 1U << static_cast<unsigned>(fault); }
  static FaultSet of_bits(std::uint32_t bits) {
    FaultSet faults;
    faults.bits_ = bits;
    return faults;
  }

 private:
  std::uint32_t bits_ = 0;
};

/// The faults from too_few_points to rings_share_border, and polygons_share_border; also polygons_overlap where edges
/// of two polygons cross. `dropped`: how many rings have no area. Cost: O((n + k) log n).
FaultSet find_ring_faults(const RegionView& feature, std::uint32_t& dropped);

}  // namespace oblast::internal::repairing
