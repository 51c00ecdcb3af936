// The public zones: objects are settled, their free edges sampled, and the cells of the samples laid under the objects.
#include <oblast/zones.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "base/public_call.h"
#include "base/stage_shares.h"
#include "buffer/zone.h"
#include "collect/collect.h"
#include "features/keyed_overlay.h"
#include "overlay/report.h"
#include "regions/validate.h"
#include "zones/cell_borders.h"
#include "zones/sampling.h"
#include "zones/settled_edges.h"
#include "zones/whole_cells.h"
#include "zones/zone_rows.h"

namespace oblast {
using namespace internal;
using namespace internal::zoning;
namespace {

/// C in units in the last place of the largest coordinate. A centre is off by 0.71 of a unit, a sample by 2; noding
/// moves objects and borders by 2 each; a distance that is compared with another one is off by the sum for both; a
/// check of pieces takes two that are straight within 8 units for one (piece_check.h).
constexpr double rounding_units = 48;

void check_zone_options(const ZoneOptions& options) {
  const auto refuse = [](const std::string& what) { throw Error(ErrorCode::bad_option, what); };
  if (!(options.tolerance >= 0 && std::isfinite(options.tolerance)))
    refuse("tolerance is " + std::to_string(options.tolerance) + "; it must be 0 or more");
  if (!(options.relative_tolerance >= 1e-12 && options.relative_tolerance <= 0.1))
    refuse("relative_tolerance is " + std::to_string(options.relative_tolerance) + "; it must be from 1e-12 to 0.1");
  if (!(options.distance > 0)) refuse("distance is " + std::to_string(options.distance) + "; it must be above 0");
  if (std::isfinite(options.distance) && !in_domain(options.distance))
    refuse("distance is " + std::to_string(options.distance) + ", which is not in the domain of coordinates");
}

void check_objects(const ShapeView& shapes, const RegionView& frame) {
  validate(shapes.regions, 0);
  validate(RegionView{shapes.lines.points, shapes.lines.line_ends, {}}, 1);
  const std::uint32_t all_points[] = {checked_index(shapes.points.size(), "points in one call", most_vertices)};
  validate(RegionView{shapes.points, std::span(all_points).first(shapes.points.empty() ? 0 : 1), {}}, 2);
  validate(frame, 3);
}

/// Whether the cells that may be rows as they are (whole_cells.h) are noded with the others.
enum class WholeCellsAre { apart, noded };

class Zones {
 public:
  Zones(const Objects& objects, const RegionView& frame, const ZoneOptions& options, WholeCellsAre whole_cells,
        Control& control)
      : objects_(objects),
        whole_cells_(whole_cells),
        frame_(frame),
        options_(options),
        control_(control),
        room_(make_room(objects.shapes, frame, options)),
        changes_(2 * std::size_t{objects.count} + 3) {}

  /// Nothing if whole cells can not be kept apart.
  std::optional<FeatureSet> run(ZoneStatistics& statistics) {
    statistics.tolerance = room_.tolerance;
    statistics.rounding = rounding_units * room_.unit;
    SettledObjects settled;
    {
      const InStage stage(Stage::collect, zone_objects_share, control_, statistics.overlay);
      settled = settle_objects(objects_, changes_, control_, statistics.overlay);
    }
    noding::Strands strands;
    {
      const InStage stage(Stage::collect, zone_sampling_share, control_, statistics.overlay);
      strands = cells(settled, statistics);
      append(std::move(settled.polygons), strands);
      strands.rules.sources = &changes_;
    }
    add_limits(strands, statistics);
    Options options;
    options.statistics = &statistics.overlay;
    KeyedResult noded = keyed_overlay_of(std::move(strands), KeyRule::lowest(frame_source(), reach_source()), options,
                                         control_, statistics.overlay);
    if (!whole_.empty() && !has_outline(noded, rest(), whole_)) return {};
    return rows_of(std::move(noded), whole_, objects_.count);
  }

 private:
  /// Above all objects: all whole cells together, the frame, and how far zones reach.
  std::uint32_t rest() const { return objects_.count; }
  std::uint32_t frame_source() const { return objects_.count + 1; }
  std::uint32_t reach_source() const { return std::isfinite(options_.distance) ? objects_.count + 2 : no_feature; }

  RegionView frame() const {
    return room_.box_frame.empty() ? frame_ : RegionView{room_.box_frame, {&corners_of_box_, 1}, {}};
  }

  noding::Strands cells(const SettledObjects& settled, ZoneStatistics& statistics) {
    const Skeleton skeleton = find_skeleton(settled, room_);
    Sampled sampled = sample(skeleton, room_);
    statistics.sites = sampled.sites;
    statistics.rounds = sampled.rounds;
    statistics.error = sampled.error;
    if (skeleton.edges.empty() && reach_source() == no_feature && whole_cells_ == WholeCellsAre::apart)
      whole_ = take_whole_cells(sampled.diagram, FrameInterior(frame()), rest());
    noding::Strands strands;
    // Points alone have nothing to flatten: all their borders are straight.
    const double flattening = skeleton.edges.empty() ? 0 : room_.flattening;
    append_cell_borders(sampled.diagram, skeleton.contacts, flattening, changes_, strands);
    statistics.error += 2 * flattening;
    if (append_strips(skeleton, sampled.narrow, strands))
      statistics.error = std::max(statistics.error, room_.tolerance / 16);
    return strands;
  }

  /// Edges that may pass through cells of other objects get strips along them, which count as area of their objects. So
  /// lines lie in their zones exactly, and borders of cells that end at polygons do not move them. True if there are
  /// some.
  static bool append_strips(const Skeleton& skeleton, const Array<bool>& narrow, noding::Strands& strands) {
    bool found = false;
    for (std::size_t e = 0; e < skeleton.edges.size(); ++e) {
      const FreeEdge& edge = skeleton.edges[e];
      const auto right = skeleton.strips.right(e), left = skeleton.strips.left(e);
      if (!narrow[e] || (right.empty() && left.empty())) continue;
      const auto add = [&](const Point& p) {
        if (strands.points.back() != p) strands.points.push_back(p);
      };
      strands.points.push_back(edge.low);
      for (const Point& p : right) add(p);
      add(edge.high);
      for (const Point& p : left) add(p);
      add(edge.low);
      strands.close_strand({static_cast<std::int32_t>(edge.object) + 1, 0}, noding::any_group);
      found = true;
    }
    return found;
  }

  /// The frame, and how far zones reach.
  void add_limits(noding::Strands& strands, ZoneStatistics& statistics) {
    add_region(frame(), frame_source(), strands, statistics.overlay);
    if (reach_source() == no_feature) return;
    BufferOptions options;
    options.mode = BufferMode::outside;
    options.absolute_tolerance = room_.tolerance;
    BufferStatistics buffered;
    const PipelineResult reach = buffering::zone_of(objects_.shapes, options_.distance, options, control_, buffered);
    statistics.rounding += buffered.rounding;
    add_region(reach.regions, reach_source(), strands, statistics.overlay);
  }

  void add_region(const RegionView& region, std::uint32_t source, noding::Strands& strands, Statistics& statistics) {
    const Array<std::uint32_t> sources(region.polygon_count(), source);
    const Operand operand{region, false, FillRule::polygons(), sources};
    append(collect({&operand, 1}, resolve_by_pipeline(control_), statistics.resolved_polygons), strands);
  }

  static void append(noding::Strands&& from, noding::Strands& to) {
    const std::size_t before = to.points.size();
    check_count(before + from.points.size(), "vertices of strands");
    to.points.insert(to.points.end(), from.points.begin(), from.points.end());
    for (std::size_t s = 0; s < from.size(); ++s) {
      to.ends.push_back(static_cast<std::uint32_t>(before + from.ends[s]));
      to.change.push_back(from.change[s]);
      // Groups number the polygons of one operand, so only one of all that are appended may have some.
      to.group.push_back(from.simplicity[s] == noding::Simplicity::assumed ? from.group[s] : noding::any_group);
      to.simplicity.push_back(from.simplicity[s]);
    }
    from = {};
  }

  static constexpr std::uint32_t corners_of_box_ = 4;

  const Objects& objects_;
  const WholeCellsAre whole_cells_;
  const RegionView& frame_;
  const ZoneOptions& options_;
  Control& control_;
  const Room room_;
  noding::SourceChanges changes_;
  WholeCells whole_;
};

/// Whole cells apart if that is possible.
FeatureSet zones_of(const Objects& objects, const RegionView& frame, const ZoneOptions& options, Control& control,
                    ZoneStatistics& statistics) {
  std::optional<FeatureSet> rows;
  for (const WholeCellsAre whole_cells : {WholeCellsAre::apart, WholeCellsAre::noded}) {
    statistics = {};
    rows = Zones(objects, frame, options, whole_cells, control).run(statistics);
    if (rows) break;
  }
  return std::move(*rows);
}

}  // namespace

FeatureSet zones(const ShapeFeatures& features, const RegionView& frame, const ZoneOptions& options) {
  check_zone_options(options);
  const ShapeView& shapes = features.shapes;
  const std::size_t drawn = shapes.regions.points.size() + shapes.lines.points.size();
  const std::size_t given = drawn + shapes.points.size() + frame.points.size();
  // Lines and outlines become many samples, so such a call is not a small one.
  const std::size_t vertices = drawn > 0 ? given + tuning::small_call : given;
  return public_call(options, options.statistics != nullptr, vertices, [&](Control& control) {
    check_objects(shapes, frame);
    const Objects objects = read_objects(features);
    ZoneStatistics statistics;
    FeatureSet rows;
    if (given > frame.points.size()) {
      rows = zones_of(objects, frame, options, control, statistics);
    } else {
      rows = rows_of({}, {}, objects.count);
    }
    if (options.statistics) {
      const RegionView lines{shapes.lines.points, shapes.lines.line_ends, {}};
      const RegionView operands[] = {shapes.regions, lines, frame};
      report(operands, rows.regions, statistics.overlay);
      *options.statistics = statistics;
    }
    return rows;
  });
}

}  // namespace oblast
