// Rings, lines and points into flat arrays; see layer_builder.h.
#include "io/layer_builder.h"

#include <fmt/format.h>
#include <oblast/domain.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/crs.h"
#include "io/read_parts.h"

namespace oblast::io {

namespace {

// The library has 32-bit indices and refuses more vertices than this in one call (error.h).
constexpr std::size_t most_vertices = std::numeric_limits<std::int32_t>::max();

std::string fault_of(double coordinate) {
  if (std::isnan(coordinate)) return "is not a number (NaN)";
  if (std::isinf(coordinate)) return "is infinite";
  return fmt::format("is {}, outside the domain (0, or {:.1e} to {:.1e} in magnitude)", coordinate, domain_smallest,
                     domain_largest);
}

}  // namespace

void LayerBuilder::set_crs(std::string wkt) {
  const auto note = [&](std::string text) {
    if (std::find(layer_.notes.begin(), layer_.notes.end(), text) == layer_.notes.end())
      layer_.notes.push_back(std::move(text));
  };
  if (wkt.empty() && !options_.assume_crs.empty()) {
    wkt = options_.assume_crs;
    note(fmt::format("the coordinates of files that name no coordinate system are taken to be in {}", crs_name(wkt)));
  }
  scan_.emplace(wkt);
  if (!options_.target_crs.empty() && wkt.empty())
    throw IoError(
        fmt::format("{} names no coordinate system, so it cannot be transformed to {}; say with --assume-crs "
                    "in which system the coordinates are",
                    layer_.files[file_], crs_name(options_.target_crs)));
  layer_.crs_wkt = wkt;
  if (options_.target_crs.empty() || same_crs(wkt, options_.target_crs)) return;
  transform_.emplace(wkt, options_.target_crs);
  layer_.crs_wkt = options_.target_crs;
  note(fmt::format("transformed from {} to {}; edges stay straight", crs_name(wkt), transform_->target_name()));
}

void LayerBuilder::append(const LayerBuilder& part, std::span<const std::int64_t> ids) {
  if (scan_ && part.scan_) scan_->add(*part.scan_);
  const std::size_t first = layer_.features.size();
  append_shapes(layer_, part.layer_);
  if (layer_.regions.points.size() > most_vertices)
    throw IoError(layer_.files[file_] + ": more than 2^31 - 1 vertices in one operand");
  for (std::size_t f = first; f < layer_.features.size(); ++f) {
    FeatureRange& feature = layer_.features[f];
    feature.feature = ids[static_cast<std::size_t>(feature.feature)];
    feature.file = file_;
  }
}

void LayerBuilder::finish() {
  if (scan_) scan_->report_to(layer_.report);
}

std::span<const Point> LayerBuilder::transformed(std::span<const Point> vertices, Part part) {
  moved_.assign(vertices.begin(), vertices.end());
  transform_->apply(moved_);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (in_domain(moved_[i].x) && in_domain(moved_[i].y)) continue;
    throw IoError(fmt::format("{}: ({}, {}) cannot be transformed to {}", where(part, i), vertices[i].x, vertices[i].y,
                              transform_->target_name()));
  }
  return moved_;
}

std::span<const Point> LayerBuilder::checked(std::span<const Point> vertices, Part part) {
  check(vertices, part);
  if (scan_) scan_->add_ring(vertices);
  return transform_ ? transformed(vertices, part) : vertices;
}

void LayerBuilder::begin_feature(std::int64_t id, std::string extra) {
  feature_ = id;
  extra_ = std::move(extra);
  first_polygon_ = static_cast<std::uint32_t>(layer_.regions.polygon_ends.size());
  first_line_ = layer_.others.line_ends.size();
  first_point_ = layer_.others.points.size();
  part_ = 0;
  has_z_ = has_m_ = other_seen_ = false;
}

void LayerBuilder::begin_polygon() {
  ++part_;
  ring_ = 0;
}

void LayerBuilder::add_ring(std::span<const Point> ring) {
  ++ring_;
  if (ring.empty()) return;
  ring = checked(ring, Part::ring);
  auto& points = layer_.regions.points;
  if (points.size() + ring.size() > most_vertices) refuse("more than 2^31 - 1 vertices in one operand");

  if (ring.size() > 1) {
    if (ring.front() == ring.back()) {
      ring = ring.first(ring.size() - 1);
    } else {
      ++layer_.report.unclosed_contours;
      if (options_.vertices == RingVertices::all)
        layer_.open_contours.push_back(static_cast<std::uint32_t>(layer_.regions.contour_ends.size()));
    }
  }
  const std::size_t begin = points.size();
  points.push_back(ring.front());
  for (const Point& p : ring.subspan(1)) {
    if (p != points.back() || options_.vertices == RingVertices::all) points.push_back(p);
  }
  if (options_.vertices == RingVertices::cleaned)
    while (points.size() > begin + 1 && points.back() == points[begin]) points.pop_back();
  if (turn_) std::reverse(points.begin() + static_cast<std::ptrdiff_t>(begin) + 1, points.end());
  layer_.report.repeated_vertices += ring.size() - (points.size() - begin);
  layer_.regions.contour_ends.push_back(static_cast<std::uint32_t>(points.size()));
}

void LayerBuilder::end_polygon() {
  if (scan_) scan_->end_polygon();
  auto& regions = layer_.regions;
  const std::uint32_t before = regions.polygon_ends.empty() ? 0 : regions.polygon_ends.back();
  const auto contours = static_cast<std::uint32_t>(regions.contour_ends.size());
  if (contours > before) regions.polygon_ends.push_back(contours);
}

void LayerBuilder::add_line(std::span<const Point> line) {
  ++part_;
  if (line.empty()) return;
  line = checked(line, Part::line);
  if (scan_) scan_->end_polygon();
  LinesAndPoints& others = layer_.others;
  if (others.line_vertices.size() + line.size() > most_vertices)
    refuse("more than 2^31 - 1 vertices of lines in one operand");
  const std::size_t begin = others.line_vertices.size();
  for (const Point& p : line)
    if (others.line_vertices.size() == begin || p != others.line_vertices.back()) others.line_vertices.push_back(p);
  layer_.report.repeated_vertices += line.size() - (others.line_vertices.size() - begin);
  others.line_ends.push_back(static_cast<std::uint32_t>(others.line_vertices.size()));
  others.line_features.push_back(feature_index());
}

void LayerBuilder::add_point(const Point& point) {
  ++part_;
  const std::span<const Point> one = checked({&point, 1}, Part::point);
  LinesAndPoints& others = layer_.others;
  if (others.points.size() == most_vertices) refuse("more than 2^31 - 1 points in one operand");
  others.points.push_back(one.front());
  others.point_features.push_back(feature_index());
}

void LayerBuilder::end_feature() {
  auto& report = layer_.report;
  ++report.features;
  if (has_z_) ++report.with_z;
  if (has_m_) ++report.with_m;
  const bool has_polygons = layer_.regions.polygon_ends.size() > first_polygon_;
  if (has_polygons || options_.entries == FeatureEntries::all)
    layer_.features.push_back({first_polygon_, file_, feature_});
  const bool has_others = layer_.others.line_ends.size() > first_line_ || layer_.others.points.size() > first_point_;
  if (!has_polygons && !has_others && !other_seen_) ++report.empty_geometries;
}

void LayerBuilder::null_geometry() {
  ++layer_.report.null_geometries;
  other_seen_ = true;
}

void LayerBuilder::line(const std::string& type) { pass_over(type, layer_.report.lines); }
void LayerBuilder::point(const std::string& type) { pass_over(type, layer_.report.points); }

void LayerBuilder::pass_over(const std::string& type, std::uint64_t& count) {
  if (options_.other == OtherGeometry::refuse) refuse("it is a " + type + ", not a polygon");
  ++count;
  other_seen_ = true;
}

void LayerBuilder::refuse(const std::string& reason) const { throw IoError(where() + ": " + reason); }

std::string LayerBuilder::where() const {
  std::string text = fmt::format("{}, feature {}", layer_.files[file_], feature_);
  if (!extra_.empty()) text += " (" + extra_ + ")";
  return text;
}

std::string LayerBuilder::where(Part part, std::size_t vertex) const {
  std::string text = fmt::format("{}, part {}", where(), part_);
  if (part == Part::ring) text += fmt::format(", ring {}", ring_);
  return part == Part::point ? text : text + fmt::format(", vertex {}", vertex);
}

void LayerBuilder::check(std::span<const Point> vertices, Part part) const {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (in_domain(vertices[i].x) && in_domain(vertices[i].y)) continue;
    const bool at_x = !in_domain(vertices[i].x);
    throw IoError(
        fmt::format("{}: {} {}", where(part, i), at_x ? "x" : "y", fault_of(at_x ? vertices[i].x : vertices[i].y)));
  }
}

}  // namespace oblast::io
