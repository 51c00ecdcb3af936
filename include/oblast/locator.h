// Where points lie: regions prepared once, to be asked millions of times.
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

/// Regions under even-odd of all contours: what an overlay or `unite` gives is read so; any other contours may be
/// given, too. Answers are exact, on every point to the last bit: decided by `orientation`, never by a computed
/// coordinate.
///
/// A copy of the contours is kept, so the caller's arrays may go. May be asked from several threads at once.
/// Cost: O(n log n) time; O(n) memory, some 100 to 200 bytes an edge, but O(n log n) where many long edges crowd. A query
/// looks at one cell of a grid, or of a grid within a cell, with a few edges; where many edges crowd even there,
/// O(log^2 n), as long as edges meet at vertices only (which holds for results), and O(n) at worst where they cross.
/// One call for many points takes about half the time of a call a point, even on one thread.
class OBLAST_API Locator {
 public:
  /// Throws Error: not_finite, out_of_domain, too_large, bad_offsets, bad_option, cancelled, memory_limit.
  explicit Locator(const RegionView& regions, const CallOptions& options = {});
  ~Locator();
  Locator(Locator&&) noexcept;
  Locator& operator=(Locator&&) noexcept;

  /// Throws Error: not_finite, out_of_domain.
  Location locate(const Point& point) const;

  /// locations[i] is that of points[i]; on all cores. Throws Error: precondition where the spans differ in length;
  /// not_finite and out_of_domain with the vertex; too_large, bad_option, cancelled, memory_limit. Then some of the
  /// locations are written.
  void locate(std::span<const Point> points, std::span<Location> locations, const CallOptions& options = {}) const;

 private:
  struct Prepared;
  std::unique_ptr<const Prepared> prepared_;
};

}  // namespace oblast
