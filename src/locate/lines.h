// Lines along one axis that part it into columns, or rows, of equal width.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace oblast::internal::locate {

/// What a query reads. at() does not decrease; it is computed, and the computation is what decides where a point
/// belongs.
struct Lines {
  double first = 0, lines_a_unit = 0;
  std::uint32_t last = 0;  ///< below 2^31

  /// The column of a value; the first one before all, the last one after all.
  std::uint32_t at(double value) const {
    const double guess = std::clamp((value - first) * lines_a_unit, 0.0, 0x1p31);
    return std::min(static_cast<std::uint32_t>(static_cast<std::int64_t>(guess)), last);
  }
};

/// The same with where the lines are, for who builds.
///
/// line(i) is at or before every value of column i, and less than 2 margins before the first that could be: at() and
/// the line itself are computed by a few operations, each off by half a unit in its last place at most. So what may
/// come by between line(i) and the values of column i has its column, from at(x - 2 margin) to at(x + 2 margin), among
/// them.
class PartedAxis {
 public:
  PartedAxis() = default;
  /// Of values from `first` to `end`. REQUIRES: columns > 0; columns <= most_columns(...) or 1.
  PartedAxis(double first, double end, double margin, std::size_t columns)
      : step_((end - first) / static_cast<double>(columns)), margin_(margin), end_(end) {
    lines_ = {first, step_ > 0 ? 1 / step_ : 0, static_cast<std::uint32_t>(columns - 1)};
  }

  /// How large an error of a line, or of where an edge crosses one, may be: where all values are of these.
  static double margin_of(double low, double high) {
    return 0x1p-49 * (std::max(std::fabs(low), std::fabs(high)) + (high - low));
  }
  /// Columns are not so narrow that their lines would coincide.
  static double most_columns(double extent, double margin) { return extent / (1024 * margin); }

  const Lines& lines() const { return lines_; }
  std::size_t count() const { return std::size_t{lines_.last} + 1; }
  double margin() const { return margin_; }
  double line(std::size_t i) const {
    return i == 0 ? lines_.first : lines_.first + static_cast<double>(i) * step_ - margin_;
  }
  /// No value of column i is after it.
  double end_of(std::size_t i) const { return i == lines_.last ? end_ : line(i + 1) + 2 * margin_; }
  std::size_t first_by(double value) const { return lines_.at(value - 2 * margin_); }
  std::size_t last_by(double value) const { return lines_.at(value + 2 * margin_); }

 private:
  Lines lines_;
  double step_ = 0, margin_ = 0, end_ = 0;
};

}  // namespace oblast::internal::locate
