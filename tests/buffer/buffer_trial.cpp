#include "buffer/buffer_trial.h"

#include <oblast/domain.h>
#include <oblast/overlay.h>
#include <oblast/wkt.h>

#include <algorithm>
#include <cmath>

#include "generators/random.h"
#include "generators/trial.h"
#include "generators/wkt.h"
#include "verify/buffer_reference.h"
#include "verify/buffer_zone.h"
#include "verify/rational.h"
#include "verify/verify.h"

namespace oblast::testing {
namespace {

using generators::Random;

double largest_of(const OwnedShapes& shapes) {
  double largest = 0;
  for (const auto* points : {&shapes.regions.points, &shapes.line_points, &shapes.points})
    for (const Point& p : *points) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
  return largest;
}

struct Extent {
  Point low{1e300, 1e300}, high{-1e300, -1e300};
  double size() const { return std::max({high.x - low.x, high.y - low.y, 0.0}); }
};

Extent extent_of(const OwnedShapes& shapes) {
  Extent box;
  for (const auto* points : {&shapes.regions.points, &shapes.line_points, &shapes.points})
    for (const Point& p : *points) {
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
  return box;
}

void add_line(OwnedShapes& shapes, std::span<const Point> line) {
  shapes.line_points.insert(shapes.line_points.end(), line.begin(), line.end());
  shapes.line_ends.push_back(static_cast<std::uint32_t>(shapes.line_points.size()));
}

OwnedShapes shuffled(const OwnedShapes& shapes, Side side, const FillRule& fill, std::uint64_t seed) {
  Random random(seed ^ 0x73687566);
  OwnedShapes other;
  other.regions = generators::shuffled(shapes.regions, fill, seed);
  const LineView lines = shapes.view().lines;
  std::vector<std::size_t> order(lines.size());
  for (std::size_t l = 0; l < order.size(); ++l) {
    order[l] = l;
    std::swap(order[l], order[static_cast<std::size_t>(random.below(static_cast<int>(l) + 1))]);
  }
  for (const std::size_t l : order) {
    std::vector<Point> line(lines[l].begin(), lines[l].end());
    if (side == Side::both && random.one_in(2)) std::reverse(line.begin(), line.end());
    if (random.one_in(4) && !line.empty()) line.push_back(line.back());
    add_line(other, line);
  }
  other.points.assign(shapes.points.rbegin(), shapes.points.rend());
  if (!other.points.empty()) other.points.push_back(other.points.front());
  return other;
}

/// Their polygons as one set, in order.
RegionSet together(const RegionSet& a, const RegionSet& b) {
  std::vector<std::vector<std::vector<Point>>> polygons;
  for (const RegionSet* set : {&a, &b})
    for (const PolygonView polygon : set->polygons()) {
      polygons.emplace_back();
      for (const std::span<const Point> contour : polygon.contours())
        polygons.back().emplace_back(contour.begin(), contour.end());
    }
  std::sort(polygons.begin(), polygons.end(), [](const auto& p, const auto& q) {
    return std::lexicographical_compare(p[0].begin(), p[0].end(), q[0].begin(), q[0].end(), lexicographically_less);
  });
  RegionSet all;
  for (const auto& polygon : polygons) {
    for (const auto& contour : polygon) {
      all.points.insert(all.points.end(), contour.begin(), contour.end());
      all.contour_ends.push_back(static_cast<std::uint32_t>(all.points.size()));
    }
    all.polygon_ends.push_back(static_cast<std::uint32_t>(all.contour_ends.size()));
  }
  return all;
}

class BufferTrial {
 public:
  BufferTrial(const BufferQuestion& question, std::uint64_t seed, BufferFigures* figures)
      : question_(question), options_(question.options), seed_(seed), figures_(figures) {}

  std::optional<BufferFailure> run() {
    try {
      options_.statistics = &statistics_;
      const RegionSet zone = buffer(question_.shapes.view(), question_.distance, options_);
      options_.statistics = nullptr;
      if (const auto fault = verify::check_result(zone)) return BufferFailure{BrokenBuffer::closed, fault->what};
      if (const auto fault = fault_of_bounds(zone)) return BufferFailure{BrokenBuffer::bounds, fault->what};
      if (buffer(shuffled(question_.shapes, options_.side, options_.fill, seed_).view(), question_.distance,
                 options_) != zone)
        return BufferFailure{BrokenBuffer::order, "other bytes"};
      if (!is_local(zone)) return BufferFailure{BrokenBuffer::far, "other bytes"};
      if (seed_ % 4 == 0 && !is_the_same_by_threads(zone)) return BufferFailure{BrokenBuffer::threads, "other bytes"};
      if (auto what = fault_of_larger(zone)) return BufferFailure{BrokenBuffer::monotone, *what};
      if (seed_ % 4 == 1 && !is_the_same_as_row(zone)) return BufferFailure{BrokenBuffer::rows, "other bytes"};
      return {};
    } catch (const std::exception& e) {
      return BufferFailure{BrokenBuffer::threw, e.what()};
    }
  }

 private:
  bool round() const {
    return options_.join == Join::round && options_.cap == Cap::round && options_.side == Side::both;
  }

  verify::ZoneBounds bounds() const {
    const double d = std::fabs(question_.distance);
    verify::ZoneBounds bounds{d * statistics_.lower_factor - statistics_.rounding,
                              d * statistics_.upper_factor + statistics_.rounding};
    if (options_.mode == BufferMode::outside) bounds.lower = d;
    if (options_.mode == BufferMode::inside && d > statistics_.rounding) bounds.upper = d;
    bounds.check_lower = round();
    if (options_.join == Join::bevel || options_.cap == Cap::flat) {
      bounds.slack = statistics_.rounding;
      bounds.upper += statistics_.rounding;
    }
    bounds.holds_lines = options_.side == Side::both;
    // Tips of mitres: the limit along the middle, and as much across.
    if (options_.join == Join::mitre) bounds.upper = 1.5 * options_.mitre_limit * (d + statistics_.rounding);
    if (options_.cap == Cap::square) bounds.upper = std::max(bounds.upper, 1.5 * d + statistics_.rounding);
    bounds.samples = 40;
    bounds.seed = seed_;
    return bounds;
  }

  std::optional<verify::Fault> fault_of_bounds(const RegionSet& zone) const {
    if (question_.distance == 0) return {};
    Options unite_options;
    unite_options.fill_a = options_.fill;
    const RegionSet united = unite(question_.shapes.regions, unite_options);
    verify::ZoneOf shapes{united, {}};
    const verify::ZoneBounds zone_bounds = bounds();
    verify::ZoneDistances distances;
    if (question_.distance < 0) {
      auto fault = verify::check_inner_zone(zone, shapes, zone_bounds, &distances);
      note(zone_bounds, distances);
      if (!fault && is_for_references(shapes)) fault = verify::check_inner_references(zone, shapes, zone_bounds);
      return fault;
    }
    const LineView lines = question_.shapes.view().lines;
    for (std::size_t l = 0; l < lines.size(); ++l) {
      const std::span<const Point> line = lines[l];
      for (std::size_t i = 0; i + 1 < line.size(); ++i) shapes.segments.push_back({line[i], line[i + 1]});
      if (line.size() == 1) shapes.segments.push_back({line[0], line[0]});
    }
    for (const Point& p : question_.shapes.points) shapes.segments.push_back({p, p});
    if (options_.cap == Cap::flat && zone.empty()) return {};
    if (options_.cap == Cap::flat) drop_points(shapes, statistics_.rounding);
    if (shapes.regions.points.empty() && shapes.segments.empty()) return {};
    auto fault = verify::check_zone(zone, shapes, zone_bounds, &distances);
    note(zone_bounds, distances);
    if (!fault && is_for_references(shapes)) fault = verify::check_references(zone, shapes, zone_bounds);
    return fault;
  }

  /// One of eight zones of few edges: references cost thousands of exact numbers an edge.
  bool is_for_references(const verify::ZoneOf& shapes) const {
    return round() && seed_ % 8 == 2 && shapes.regions.points.size() + shapes.segments.size() <= 30;
  }

  /// A flat cap makes nothing of a point, and what is smaller than rounding may stick out of it.
  static void drop_points(verify::ZoneOf& shapes, double rounding) {
    std::erase_if(shapes.segments, [&](const auto& s) { return std::hypot(s.b.x - s.a.x, s.b.y - s.a.y) <= rounding; });
  }

  void note(const verify::ZoneBounds& bounds, const verify::ZoneDistances& distances) const {
    if (!figures_) return;
    figures_->pockets += statistics_.closed_pockets;
    figures_->folded += statistics_.folded_pieces;
    if (!round()) return;
    figures_->furthest = std::max(figures_->furthest, distances.furthest / bounds.upper);
    if (distances.nearest > 0 && bounds.lower > 0)
      figures_->nearest = std::max(figures_->nearest, bounds.lower / distances.nearest);
  }

  /// Squares, a line and a point beside the shapes, near and very far.
  bool is_local(const RegionSet& zone) const {
    const Extent box = extent_of(question_.shapes);
    const double reach = 3 * (options_.join == Join::mitre ? options_.mitre_limit : 1) * std::fabs(question_.distance);
    const double size = std::max(box.size(), 1e-6 * std::fabs(box.high.x)) + 1e-70;
    const double steps = 4 * (reach + size) * (seed_ % 3 == 0 ? 1e6 : 1);
    if (!(std::fabs(box.high.x) + 2 * steps < 1e80)) return true;
    OwnedShapes far;
    const double x = box.high.x + steps, y = box.low.y, side = reach + size;
    for (const Point& at : {Point{x, y}, Point{x + steps, y + size / 2}}) {
      far.regions.points.insert(far.regions.points.end(),
                                {at, {at.x + side, at.y}, {at.x + side, at.y + side}, {at.x, at.y + side}});
      far.regions.contour_ends.push_back(static_cast<std::uint32_t>(far.regions.points.size()));
      far.regions.polygon_ends.push_back(static_cast<std::uint32_t>(far.regions.contour_ends.size()));
    }
    OwnedShapes all = question_.shapes;
    for (const Point& p : far.regions.points) all.regions.points.push_back(p);
    const RegionView view = question_.shapes.regions;
    if (view.polygon_ends.empty() && view.contour_count() > 0) return true;
    for (std::uint32_t p = 0; p < 2; ++p) {
      all.regions.contour_ends.push_back(static_cast<std::uint32_t>(view.points.size() + 4 * (p + 1)));
      all.regions.polygon_ends.push_back(static_cast<std::uint32_t>(view.contour_count() + p + 1));
    }
    const RegionSet beside = buffer(far.view(), question_.distance, options_);
    return buffer(all.view(), question_.distance, options_) == together(zone, beside);
  }

  bool is_the_same_by_threads(const RegionSet& zone) const {
    BufferOptions other = options_;
    other.threads = options_.threads == 1 ? 2 : 1;
    return buffer(question_.shapes.view(), question_.distance, other) == zone;
  }

  bool is_the_same_as_row(const RegionSet& zone) const {
    const ShapeView view = question_.shapes.view();
    const std::vector<std::uint32_t> rows(
        std::max({view.regions.polygon_count(), view.lines.size(), view.points.size()}), 1);
    const std::span<const std::uint32_t> all = rows;
    const double distances[] = {1, question_.distance};
    const FeatureSet set = buffer_rows(
        {view, all.first(view.regions.polygon_count()), all.first(view.lines.size()), all.first(view.points.size())},
        distances, options_);
    return set.size() == 2 && set.feature_ends[0] == 0 && set.regions == zone;
  }

  /// A vertex of the zone that a larger zone leaves out by more than rounding.
  std::optional<std::string> fault_of_larger(const RegionSet& zone) const {
    if (options_.absolute_tolerance > 0 || question_.distance == 0) return {};
    BufferOptions other = options_;
    BufferStatistics statistics;
    other.statistics = &statistics;
    const double larger = question_.distance * (question_.distance > 0 ? 1.001 : 0.999);
    const RegionSet wider = buffer(question_.shapes.view(), larger, other);
    // Pockets are not the same ones, which may move the outline within the tolerance.
    if (statistics_.closed_pockets > 0 || statistics.closed_pockets > 0) return {};
    const RegionSet left = overlay(zone, wider, Operation::difference);
    for (const Point& p : left.points) {
      double away = 1e300;
      for (const std::span<const Point> contour : wider.contours())
        for (std::size_t i = 0; i < contour.size(); ++i) {
          const Point a = contour[i], b = contour[(i + 1) % contour.size()];
          const verify::Rational found = verify::squared_distance(verify::RationalPoint(p), a, b);
          away = std::min(away, std::sqrt(static_cast<double>(found)));
        }
      if (away > 2 * statistics_.rounding)
        return "a place of the zone is not in a larger one: " + std::to_string(p.x) + " " + std::to_string(p.y);
    }
    return {};
  }

  const BufferQuestion& question_;
  BufferOptions options_;
  std::uint64_t seed_;
  BufferFigures* figures_;
  BufferStatistics statistics_;
};

}  // namespace

void BufferFigures::add(const BufferFigures& other) {
  nearest = std::max(nearest, other.nearest);
  furthest = std::max(furthest, other.furthest);
  folded += other.folded;
  pockets += other.pockets;
}

const char* to_text(BrokenBuffer broken) {
  constexpr const char* names[] = {"closed", "bounds", "order", "far", "threads", "monotone", "rows", "threw"};
  return names[static_cast<int>(broken)];
}

BufferQuestion draw_question(const generators::Operands& operands, std::uint64_t seed) {
  Random random(seed ^ 0x627566666572);
  BufferQuestion question;
  OwnedShapes& shapes = question.shapes;
  const bool only_regions = random.one_in(3);
  if (only_regions || !random.one_in(4)) shapes.regions = operands.a;
  const RegionView b = operands.b;
  if (!only_regions) {
    for (const std::span<const Point> contour : b.contours()) {
      std::vector<Point> line(contour.begin(), contour.end());
      if (random.one_in(4) && !line.empty()) line.push_back(line.front());
      if (!random.one_in(8)) add_line(shapes, line);
    }
    for (const Point& p : b.points)
      if (random.one_in(8)) shapes.points.push_back(p);
  }
  const double extent = extent_of(shapes).size(), largest = largest_of(shapes);
  const double scale = random.one_in(4) ? largest : std::max(extent, 0x1p-200);
  const double exponent = random.one_in(2) ? random.in(-2, 0.3) : random.in(-18, 3);
  double distance = scale * std::pow(10, exponent);
  if (!in_domain(distance) || distance < 0x1p-250 || !(largest + 50 * distance < 1e89)) distance = 0x1p-100;
  question.distance = random.one_in(3) ? -distance : distance;
  if (random.one_in(100)) question.distance = 0;
  BufferOptions& options = question.options;
  options.threads = 1;
  if (random.one_in(4)) options.join = random.one_in(2) ? Join::mitre : Join::bevel;
  if (random.one_in(4)) options.mitre_limit = random.in(1, 8);
  if (random.one_in(4)) options.cap = random.one_in(2) ? Cap::flat : Cap::square;
  if (random.one_in(5)) options.side = random.one_in(2) ? Side::left : Side::right;
  if (random.one_in(2)) options.mode = random.one_in(2) ? BufferMode::inside : BufferMode::outside;
  if (random.one_in(2)) options.tolerance = std::pow(10, random.in(-4, -0.31));
  if (random.one_in(8)) options.absolute_tolerance = std::fabs(distance) * std::pow(10, random.in(-4, 0));
  return question;
}

std::optional<BufferFailure> run_buffer_trial(const BufferQuestion& question, std::uint64_t seed,
                                              BufferFigures* figures) {
  return BufferTrial(question, seed, figures).run();
}

std::string to_text(const BufferQuestion& question) {
  const BufferOptions& o = question.options;
  char head[300];
  std::snprintf(head, sizeof head,
                "distance %.17g join %d limit %.17g cap %d side %d mode %d tolerance %.17g absolute %.17g\n  regions ",
                question.distance, static_cast<int>(o.join), o.mitre_limit, static_cast<int>(o.cap),
                static_cast<int>(o.side), static_cast<int>(o.mode), o.tolerance, o.absolute_tolerance);
  std::string text = head + generators::soup_to_wkt(question.shapes.regions);
  const auto add = [&](const Point& p) {
    char point[60];
    std::snprintf(point, sizeof point, " %.17g %.17g,", p.x, p.y);
    text += point;
  };
  const LineView lines = question.shapes.view().lines;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    text += "\n  line";
    for (const Point& p : lines[l]) add(p);
  }
  text += "\n  points";
  for (const Point& p : question.shapes.points) add(p);
  return text;
}

}  // namespace oblast::testing
