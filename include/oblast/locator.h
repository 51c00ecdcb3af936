// Point-in-region queries: regions are prepared once and then answer any number of queries.
#pragma once

#include <oblast/error.h>
#include <oblast/export.h>
#include <oblast/options.h>
#include <oblast/point.h>
#include <oblast/region_set.h>

#include <memory>
#include <span>

namespace oblast {

enum class Location { outside, boundary, inside };

/// Regions, filled by even-odd of all contours together. The result of an overlay has this fill. Any other contours are
/// allowed, too. Answers are exact: only orientation tests decide, never a computed coordinate.
///
/// The locator copies the contours, so the caller may free the arrays. Several threads may use it at once.
/// Cost to prepare n edges: O(n log n) time; O(n) memory, about 100 to 200 bytes per edge, but O(n log n) if many long
/// edges crowd. Cost of a query: it reads one cell of a grid, or of a grid within a cell, usually with a few edges. If
/// many edges crowd even there, a query takes O(log^2 n) if edges meet at vertices only (which holds for results), and
/// O(n) in the worst case if they cross. One call for many points takes about half the time of a call per point.
class OBLAST_API Locator {
 public:
  /// Throws Error: not_finite, out_of_domain, too_large, bad_offsets, bad_option, cancelled, memory_limit.
  explicit Locator(const RegionView& regions, const CallOptions& options = {});
  ~Locator();
  Locator(Locator&&) noexcept;
  Locator& operator=(Locator&&) noexcept;

  /// Throws Error: not_finite, out_of_domain.
  Location locate(const Point& point) const;

  /// Writes the location of points[i] to locations[i], on CallOptions::threads threads.
  /// Throws Error: precondition if the spans differ in length; not_finite and out_of_domain, with the index of the
  /// point in Place::vertex; too_large, bad_option, cancelled, memory_limit. After an error some of the locations may
  /// be written.
  void locate(std::span<const Point> points, std::span<Location> locations, const CallOptions& options = {}) const;

 private:
  struct Prepared;
  std::unique_ptr<const Prepared> prepared_;
};

}  // namespace oblast
