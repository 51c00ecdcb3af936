// What answers a million questions whether a point is inside of regions.
#pragma once

#include <oblast/region_set.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace oblast::bench {

class Contestant {
 public:
  virtual ~Contestant() = default;

  virtual std::string name() const = 0;
  /// Who it is, for the ratio: the best of a library's ways counts.
  virtual std::string library() const = 0;
  /// Whether points on the boundary are answered by 1, too.
  virtual bool with_boundary() const { return false; }
  virtual bool on_all_cores() const { return false; }
  /// The regions in its own types; not timed.
  virtual void load(const RegionView& regions) = 0;
  /// Everything that is made once for all questions. What is made at the first question is asked for here.
  virtual void build() = 0;
  virtual void ask(std::span<const Point> points, std::span<std::uint8_t> inside) = 0;
};

std::vector<std::unique_ptr<Contestant>> oblast_contestants();
std::vector<std::unique_ptr<Contestant>> boost_contestants();
/// By the C interface of this library (libgeos_c.so of 3.12 or newer). Throws where there is none.
std::vector<std::unique_ptr<Contestant>> geos_contestants(const std::string& library_file);

}  // namespace oblast::bench
