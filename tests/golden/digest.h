// A digest of bytes: XXH3, 64 bits, the same on every machine.
#pragma once

#include <oblast/region_set.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace oblast::golden {

class Digest {
 public:
  Digest();

  void add(std::uint64_t number);
  void add(std::span<const std::uint32_t> numbers);
  void add(std::span<const Point> points);
  /// Points by their bits, contour_ends, polygon_ends; the length of each, too.
  void add(const RegionView& regions);

  std::uint64_t value() const;

 private:
  void add_bytes(const void* bytes, std::size_t size);

  struct State;
  struct Free {
    void operator()(State* state) const;
  };
  std::unique_ptr<State, Free> state_;
};

}  // namespace oblast::golden
