// Collects the features of one file in a Layer: polygons and their rings, lines and points. Checks every coordinate.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/coordinate_scan.h"
#include "io/layer.h"
#include "io/point_transform.h"
#include "io/read.h"

namespace oblast::io {

/// Use: set_crs, then for each feature: begin_feature, then begin_polygon, add_ring..., end_polygon any number of
/// times, end_feature. At the end finish.
class LayerBuilder {
 public:
  /// `file` is an index into layer.files.
  LayerBuilder(Layer& layer, std::uint32_t file, const ReadOptions& options)
      : layer_(layer), file_(file), options_(options) {}

  /// The coordinate system of the file as WKT, or an empty text. The options may assume one, and may ask for another
  /// one: then rings are transformed. Throws IoError.
  void set_crs(std::string wkt);

  /// `extra` is put into messages after the feature ("line 3"), if not empty.
  void begin_feature(std::int64_t id, std::string extra = {});
  void begin_polygon();
  /// A ring as it is in the file, closing point included or not. Throws IoError for a coordinate that
  /// is not finite or outside the domain.
  void add_ring(std::span<const Point> ring);
  void end_polygon();
  /// True if lines and points are wanted: then add_line and add_point get them. Else `line` and `point` are called.
  bool keeps_others() const { return options_.other == OtherGeometry::keep; }
  /// The vertices of a line, and a point. Throw IoError as add_ring does.
  void add_line(std::span<const Point> line);
  void add_point(const Point& point);
  void end_feature();
  /// Appends what another builder has made of the next part of the same file. Feature f of it gets the number `ids[f]`.
  void append(const LayerBuilder& part, std::span<const std::int64_t> ids);
  /// Adds what was seen of the coordinates to the report.
  void finish();

  /// From now on rings are reversed, and keep their first vertex. For shapefiles, whose outer rings run clockwise.
  void turn_rings() { turn_ = true; }

  void null_geometry();
  void with_z() { has_z_ = true; }
  void with_m() { has_m_ = true; }
  /// A line or a point that is not wanted: counted, or refused with OtherGeometry::refuse.
  void line(const std::string& type);
  void point(const std::string& type);
  [[noreturn]] void refuse(const std::string& reason) const;

  /// "fires/0412.shp, feature 17"
  std::string where() const;

 private:
  enum class Part { ring, line, point };
  std::span<const Point> transformed(std::span<const Point> vertices, Part part);
  void check(std::span<const Point> vertices, Part part) const;
  std::string where(Part part, std::size_t vertex) const;
  std::span<const Point> checked(std::span<const Point> vertices, Part part);
  std::uint32_t feature_index() const { return static_cast<std::uint32_t>(layer_.features.size()); }
  void pass_over(const std::string& type, std::uint64_t& count);

  Layer& layer_;
  std::uint32_t file_;
  const ReadOptions& options_;
  std::optional<CoordinateScan> scan_;
  std::optional<PointTransform> transform_;
  std::vector<Point> moved_;  // a ring after the transformation
  std::int64_t feature_ = 0;
  std::string extra_;
  std::uint32_t first_polygon_ = 0;  // of the feature
  std::size_t first_line_ = 0, first_point_ = 0;
  std::uint64_t part_ = 0;  // number for messages: counted from 1, with empty parts
  std::uint64_t ring_ = 0;
  bool has_z_ = false;
  bool has_m_ = false;
  bool other_seen_ = false;
  bool turn_ = false;
};

}  // namespace oblast::io
