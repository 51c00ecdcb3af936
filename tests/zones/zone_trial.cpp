#include "zones/zone_trial.h"

#include <oblast/domain.h>

#include <algorithm>
#include <cmath>

#include "base/index_limits.h"
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
      if (auto failure = judge(question_, rows, statistics_)) return failure;
      const ZoneQuestion other = shuffled(question_, trial_.seed);
      if (zones(other.view(), other.frame, options_) != rows) return ZoneFailure{BrokenZones::order, "other bytes"};
      if (trial_.seed % 4 == 0 && !is_the_same_by_threads(rows))
        return ZoneFailure{BrokenZones::threads, "other bytes"};
      // If no object has a place, all of the frame is nearest to the far one.
      if (trial_.seed % 4 == 1 && !rows.regions.points.empty()) return run_in_company();
      return {};
    } catch (const Error& e) {
      if (leaves_the_domain(box_of_all()) || (internal::low_index_limits && e.code() == ErrorCode::too_large))
        return {};
      return ZoneFailure{BrokenZones::threw, e.what()};
    } catch (const std::exception& e) {
      return ZoneFailure{BrokenZones::threw, e.what()};
    }
  }

 private:
  /// Whether everything, widened by eight times its extent, leaves the domain, as zones() requires it not to.
  static bool leaves_the_domain(const verify::Box& box) {
    const double widened = 8 * std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    return std::max({box.high.x + widened, box.high.y + widened, widened - box.low.x, widened - box.low.y}) >
           domain_largest;
  }

  /// Another object, to which no place of the frame is near, with frame and tolerance given: its zone is empty, and the
  /// zones of the others are judged as before.
  std::optional<ZoneFailure> run_in_company() {
    ZoneQuestion alone = question_;
    if (const auto box = default_box(); box && alone.frame.points.empty()) alone.frame = rectangle(*box);
    const verify::Box all = box_of_all();
    if (all.empty()) return {};
    const double side = std::max(all.high.x - all.low.x, all.high.y - all.low.y);
    const Point far{all.high.x + 4 * side, all.high.y + 2 * side};
    verify::Box with_far = all;
    with_far.add({far, far});
    if (side == 0 || leaves_the_domain(with_far)) return {};
    alone.options.tolerance = statistics_.tolerance;
    alone.options.statistics = nullptr;
    ZoneQuestion crowd = alone;
    if (!crowd.is_numbered()) crowd.number_shapes();
    crowd.points.push_back(far);
    crowd.point_rows.push_back(static_cast<std::uint32_t>(crowd.object_count()));
    ZoneStatistics statistics;
    crowd.options.statistics = &statistics;
    FeatureSet rows = zones(crowd.view(), crowd.frame, crowd.options);
    const std::size_t others = alone.object_count();
    if (rows.size() != others + 1 || (others > 0 && rows.feature_ends[others] != rows.feature_ends[others - 1]))
      return ZoneFailure{BrokenZones::company, "a far object has a zone"};
    rows.feature_ends.pop_back();
    rows.keys.pop_back();
    auto failure = judge(alone, rows, statistics);
    if (failure) failure = ZoneFailure{BrokenZones::company, failure->what};
    return failure;
  }

  std::optional<ZoneFailure> judge(const ZoneQuestion& question, const FeatureSet& rows,
                                   const ZoneStatistics& statistics) {
    if (rows.size() != question.object_count()) return ZoneFailure{BrokenZones::rows, "not a row for each object"};
    for (std::uint32_t r = 0; r < rows.size(); ++r)
      if (rows.keys[r] != FeatureKey{r, no_feature}) return ZoneFailure{BrokenZones::rows, "another key"};

    const verify::ZoneObjects objects(question.view());
    const std::optional<verify::Box> box = question.frame.points.empty() ? default_box() : std::nullopt;
    const RegionSet frame = box ? rectangle(*box) : question.frame;
    const verify::JudgedZones zones{objects, frame, rows, rows.keys};
    const bool is_whole = std::isinf(question.options.distance);
    verify::ZoneCoverMeasures cover;
    if (const auto fault = verify::check_zone_cover(zones, {statistics.rounding, is_whole}, &cover))
      return ZoneFailure{BrokenZones::cover, fault->what};

    verify::ZoneDistanceBounds bounds;
    bounds.epsilon = statistics.error + statistics.rounding;
    bounds.moved = statistics.rounding;
    bounds.places = trial_.places;
    bounds.seed = trial_.seed;
    if (!is_whole) {
      bounds.lower = question.options.distance - statistics.rounding;
      const double epsilon = std::max(statistics.tolerance, 1e-9 * question.options.distance);
      bounds.upper = question.options.distance + 2 * epsilon + statistics.rounding;
    }
    verify::ZoneDistanceMeasures distances;
    if (const auto fault = verify::check_zone_distances(zones, bounds, &distances))
      return ZoneFailure{BrokenZones::nearness, fault->what};
    note(cover, distances, statistics);
    if (auto what = fault_of(question, statistics); !what.empty()) return ZoneFailure{BrokenZones::statistics, what};
    if (!trial_.voronoi || !box || !question.has_points_only() || !question.point_rows.empty() || !is_whole) return {};
    if (const auto fault = verify::check_voronoi(question.points, *box, rows, statistics.rounding))
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

  /// Of the objects and the frame.
  verify::Box box_of_all() const {
    verify::Box box = box_of_objects();
    box.add(box_of(question_.frame.points));
    if (const auto frame = question_.frame.points.empty() ? default_box() : std::nullopt) box.add(*frame);
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

  std::string fault_of(const ZoneQuestion& question, const ZoneStatistics& statistics) const {
    const verify::Box box = box_of_objects();
    if (box.empty()) return {};
    const double side = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    const double asked =
        question.options.tolerance > 0 ? question.options.tolerance : side * question.options.relative_tolerance;
    // No tolerance is smaller than what rounding needs.
    if (statistics.tolerance > std::max(asked * (1 + 1e-9), 2 * statistics.rounding))
      return "the tolerance is larger than what was asked for";
    if (statistics.error > statistics.tolerance) return "the error is above the tolerance";
    if (question.has_points_only() && statistics.error != 0) return "points have an error";
    return {};
  }

  void note(const verify::ZoneCoverMeasures& cover, const verify::ZoneDistanceMeasures& distances,
            const ZoneStatistics& statistics) const {
    if (!figures_) return;
    figures_->excused += cover.excused;
    figures_->sites += statistics.sites;
    if (statistics.tolerance > 0)
      figures_->proved = std::max(figures_->proved, statistics.error / statistics.tolerance);
    if (distances.epsilon > 0)
      figures_->seen = std::max(figures_->seen, distances.epsilon / (statistics.error + statistics.rounding));
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
  constexpr const char* names[] = {"rows",    "cover",   "nearness", "statistics", "order",
                                   "threads", "voronoi", "company",  "threw"};
  return names[static_cast<int>(broken)];
}

void ZoneFigures::add(const ZoneFigures& other) {
  proved = std::max(proved, other.proved);
  seen = std::max(seen, other.seen);
  sites += other.sites;
  excused += other.excused;
}

std::size_t ZoneQuestion::object_count() const {
  std::size_t count = 0;
  for (const auto* rows : {&region_rows, &line_rows, &point_rows})
    for (const std::uint32_t row : *rows) count = std::max<std::size_t>(count, row + 1);
  return is_numbered() ? count : regions.view().polygon_count() + line_ends.size() + points.size();
}

bool ZoneQuestion::is_numbered() const { return !region_rows.empty() || !line_rows.empty() || !point_rows.empty(); }

void ZoneQuestion::number_shapes() {
  std::uint32_t next = 0;
  const auto number = [&](std::vector<std::uint32_t>& rows, std::size_t shapes) {
    for (std::size_t k = 0; k < shapes; ++k) rows.push_back(next++);
  };
  number(region_rows, regions.view().polygon_count());
  number(line_rows, line_ends.size());
  number(point_rows, points.size());
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
