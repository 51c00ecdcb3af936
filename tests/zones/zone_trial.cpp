#include "zones/zone_trial.h"

#include <oblast/domain.h>

#include <algorithm>
#include <cmath>

#include "verify/voronoi.h"
#include "verify/zones.h"
#include "zones/shuffled_zones.h"

namespace oblast::testing {
namespace {

class Trial {
 public:
  Trial(const ZoneQuestion& question, const ZoneTrial& trial, ZoneFigures* figures)
      : question_(question), trial_(trial), figures_(figures), options_(question.options) {}

  std::optional<ZoneFailure> run() {
    try {
      options_.statistics = &statistics_;
      const FeatureSet rows = zones(question_.view(), question_.frame, options_);
      options_.statistics = nullptr;
      if (auto failure = judge(rows)) return failure;
      const ZoneQuestion other = shuffled(question_, trial_.seed);
      if (zones(other.view(), other.frame, options_) != rows) return ZoneFailure{BrokenZones::order, "other bytes"};
      if (trial_.seed % 4 == 0 && !is_the_same_by_threads(rows))
        return ZoneFailure{BrokenZones::threads, "other bytes"};
      return {};
    } catch (const std::exception& e) {
      if (may_be_refused()) return {};
      return ZoneFailure{BrokenZones::threw, e.what()};
    }
  }

  /// Whether everything, widened by eight times its extent, leaves the domain, as zones() requires it not to.
  bool may_be_refused() const {
    verify::Box box = box_of_objects();
    box.add(box_of(question_.frame.points));
    if (const auto frame = default_box()) box.add(*frame);
    const double widened = 8 * std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    return std::max({box.high.x + widened, box.high.y + widened, widened - box.low.x, widened - box.low.y}) >
           domain_largest;
  }

 private:
  std::optional<ZoneFailure> judge(const FeatureSet& rows) {
    if (rows.size() != question_.object_count()) return ZoneFailure{BrokenZones::rows, "not a row for each object"};
    for (std::uint32_t r = 0; r < rows.size(); ++r)
      if (rows.keys[r] != FeatureKey{r, no_feature}) return ZoneFailure{BrokenZones::rows, "another key"};

    const verify::ZoneObjects objects(question_.view());
    const std::optional<verify::Box> box = question_.frame.points.empty() ? default_box() : std::nullopt;
    const RegionSet frame = box ? rectangle(*box) : question_.frame;
    const verify::JudgedZones zones{objects, frame, rows, rows.keys};
    const bool is_whole = std::isinf(options_.distance);
    verify::ZoneCoverMeasures cover;
    if (const auto fault = verify::check_zone_cover(zones, {statistics_.rounding, is_whole}, &cover))
      return ZoneFailure{BrokenZones::cover, fault->what};

    verify::ZoneDistanceBounds bounds;
    bounds.epsilon = statistics_.error + statistics_.rounding;
    bounds.moved = statistics_.rounding;
    bounds.places = trial_.places;
    bounds.seed = trial_.seed;
    if (!is_whole) {
      bounds.lower = options_.distance - statistics_.rounding;
      const double epsilon = std::max(statistics_.tolerance, 1e-9 * options_.distance);
      bounds.upper = options_.distance + 2 * epsilon + statistics_.rounding;
    }
    verify::ZoneDistanceMeasures distances;
    if (const auto fault = verify::check_zone_distances(zones, bounds, &distances))
      return ZoneFailure{BrokenZones::nearness, fault->what};
    note(cover, distances);
    if (auto what = fault_of_statistics(); !what.empty()) return ZoneFailure{BrokenZones::statistics, what};
    if (!trial_.voronoi || !box || !question_.has_points_only() || !question_.point_rows.empty() || !is_whole)
      return {};
    if (const auto fault = verify::check_voronoi(question_.points, *box, rows, statistics_.rounding))
      return ZoneFailure{BrokenZones::voronoi, fault->what};
    return {};
  }

  static verify::Box box_of(std::span<const Point> points) {
    verify::Box box;
    for (const Point& p : points) box.add({p, p});
    return box;
  }

  verify::Box box_of_objects() const {
    verify::Box box = box_of(question_.regions.points);
    box.add(box_of(question_.line_points));
    box.add(box_of(question_.points));
    return box;
  }

  /// The frame of a call without one, as zones() states it.
  std::optional<verify::Box> default_box() const {
    verify::Box box = box_of_objects();
    if (box.empty()) return std::nullopt;
    const double side = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    const double largest =
        std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
    double margin = side > 0 ? side / 10 : std::max(1.0, std::ldexp(largest, -20));
    if (!std::isinf(options_.distance)) margin = std::max(1.5 * options_.distance, std::ldexp(largest, -40));
    box.low = {box.low.x - margin, box.low.y - margin};
    box.high = {box.high.x + margin, box.high.y + margin};
    return box;
  }

  static RegionSet rectangle(const verify::Box& box) {
    return {{box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}, {4}, {1}};
  }

  std::string fault_of_statistics() const {
    const verify::Box box = box_of_objects();
    if (box.empty()) return {};
    const double side = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    const double asked = options_.tolerance > 0 ? options_.tolerance : side * options_.relative_tolerance;
    // No tolerance is smaller than what rounding needs.
    if (statistics_.tolerance > std::max(asked * (1 + 1e-9), 2 * statistics_.rounding))
      return "the tolerance is larger than what was asked for";
    if (statistics_.error > statistics_.tolerance) return "the error is above the tolerance";
    if (question_.has_points_only() && statistics_.error != 0) return "points have an error";
    return {};
  }

  void note(const verify::ZoneCoverMeasures& cover, const verify::ZoneDistanceMeasures& distances) const {
    if (!figures_) return;
    figures_->excused += cover.excused;
    figures_->sites += statistics_.sites;
    if (statistics_.tolerance > 0)
      figures_->proved = std::max(figures_->proved, statistics_.error / statistics_.tolerance);
    if (distances.epsilon > 0)
      figures_->seen = std::max(figures_->seen, distances.epsilon / (statistics_.error + statistics_.rounding));
  }

  bool is_the_same_by_threads(const FeatureSet& rows) const {
    ZoneOptions other = options_;
    other.threads = options_.threads == 1 ? 2 : 1;
    return zones(question_.view(), question_.frame, other) == rows;
  }

  const ZoneQuestion& question_;
  const ZoneTrial& trial_;
  ZoneFigures* figures_;
  ZoneOptions options_;
  ZoneStatistics statistics_;
};

}  // namespace

const char* to_text(BrokenZones broken) {
  constexpr const char* names[] = {"rows", "cover", "nearness", "statistics", "order", "threads", "voronoi", "threw"};
  return names[static_cast<int>(broken)];
}

std::size_t ZoneQuestion::object_count() const {
  std::size_t count = 0;
  for (const auto* rows : {&region_rows, &line_rows, &point_rows})
    for (const std::uint32_t row : *rows) count = std::max<std::size_t>(count, row + 1);
  const bool numbered = !region_rows.empty() || !line_rows.empty() || !point_rows.empty();
  return numbered ? count : regions.view().polygon_count() + line_ends.size() + points.size();
}

void ZoneQuestion::add_line(std::span<const Point> line) {
  line_points.insert(line_points.end(), line.begin(), line.end());
  line_ends.push_back(static_cast<std::uint32_t>(line_points.size()));
}

std::optional<ZoneFailure> run_zone_trial(const ZoneQuestion& question, const ZoneTrial& trial, ZoneFigures* figures) {
  return Trial(question, trial, figures).run();
}

std::string to_text(const ZoneQuestion& question) {
  const ZoneOptions& o = question.options;
  std::string text;
  const auto print = [&](const char* format, auto... values) {
    char buffer[200];
    std::snprintf(buffer, sizeof buffer, format, values...);
    text += buffer;
  };
  const auto add_rows = [&](const std::vector<std::uint32_t>& rows) {
    for (const std::uint32_t row : rows) print(" %u", row);
  };
  print("tolerance %.17g relative %.17g distance %.17g", o.tolerance, o.relative_tolerance, o.distance);
  for (const auto& [name, regions] :
       {std::pair("frame", question.frame.view()), {"polygons", question.regions.view()}}) {
    text += std::string("\n  ") + name;
    for (const PolygonView polygon : regions.polygons()) {
      text += " |";
      for (const std::span<const Point> contour : polygon.contours()) {
        text += ";";
        for (const Point& p : contour) print(" %.17g %.17g,", p.x, p.y);
      }
    }
  }
  text += "\n  rows";
  add_rows(question.region_rows);
  const LineView lines = question.view().shapes.lines;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    text += "\n  line";
    for (const Point& p : lines[l]) print(" %.17g %.17g,", p.x, p.y);
  }
  text += "\n  rows";
  add_rows(question.line_rows);
  text += "\n  points";
  for (const Point& p : question.points) print(" %.17g %.17g,", p.x, p.y);
  text += "\n  rows";
  add_rows(question.point_rows);
  return text;
}

}  // namespace oblast::testing
