// Reads the features as the file has them, checks them, and reports; see check_layer.h.
#include "oblast/check_layer.h"

#include <fmt/format.h>
#include <oblast/check_features.h>

#include <algorithm>

#include "io/picture_file.h"
#include "io/read.h"
#include "io/rows.h"
#include "io/write_points.h"
#include "oblast/command.h"
#include "oblast/console.h"
#include "oblast/fault_picture.h"
#include "oblast/fault_report.h"
#include "oblast/interrupt.h"
#include "oblast/job_picture.h"
#include "oblast/no_polygons.h"

namespace oblast::app {

namespace {

/// Rings of shapefiles are reversed on reading, so the last vertex of the file is the second one here.
void turn_open_rings(const io::Layer& layer, std::span<const std::uint32_t> turned, std::vector<FeatureFault>& faults) {
  for (FeatureFault& fault : faults) {
    if (fault.kind != FeatureFaultKind::ring_not_closed) continue;
    if (!std::binary_search(turned.begin(), turned.end(), fault.place.feature)) continue;
    fault.place.vertex = 1;
    fault.point = layer.regions.view().contour(fault.place.contour)[1];
  }
}

std::vector<FeatureFault> find_faults(const io::Layer& layer, const FeatureView& features,
                                      const LayerCheckArguments& arguments, JobProgress& progress) {
  const double by_itself = arguments.coverage ? 0.3 : 1;  // the share of the first check, roughly
  FeatureCheckOptions options;
  options.threads = arguments.threads;
  options.progress = [&](Stage, double fraction) {
    progress.show(Phase::computing, "looking at each feature", by_itself * fraction);
    return true;
  };
  const std::vector<std::uint32_t> without_roles = features_without_roles(layer);
  options.open_contours = layer.open_contours;
  options.features_without_roles = without_roles;
  std::vector<FeatureFault> faults = check_features(features, options);
  turn_open_rings(layer, without_roles, faults);
  if (arguments.coverage) {
    CallOptions coverage_options;
    coverage_options.threads = arguments.threads;
    coverage_options.progress = [&](Stage, double fraction) {
      progress.show(Phase::computing, "looking between the features", by_itself + (1 - by_itself) * fraction);
      return true;
    };
    const std::vector<FeatureFault> between = check_coverage(features, coverage_options);
    faults.insert(faults.end(), between.begin(), between.end());
  }
  return faults;
}

io::Existing existing(const LayerCheckArguments& arguments) {
  return arguments.overwrite ? io::Existing::overwrite : io::Existing::refuse;
}

void check_outputs(const LayerCheckArguments& arguments) {
  const std::string& file = arguments.input.file;
  if (arguments.faults == file) throw CallError("--faults names the file that is checked; name another one");
  if (arguments.picture == "-")
    throw CallError("--svg - and the findings both go to standard output; give the picture a file");
  if (!arguments.picture.empty() && (arguments.picture == arguments.faults || arguments.picture == file))
    throw CallError("--svg names a file of this call already; name another one");
  io::WriteOptions options;
  options.existing = existing(arguments);
  if (!arguments.faults.empty()) io::check_writable(arguments.faults, options);
  if (!arguments.picture.empty()) io::check_picture_writable(arguments.picture, options.existing);
}

void write_faults(const FaultReport& report, const io::Layer& layer, const LayerCheckArguments& arguments) {
  io::WriteOptions options;
  options.existing = existing(arguments);
  options.crs_wkt = layer.crs_wkt;
  std::vector<Point> points;
  for (const FeatureFault& fault : report.faults()) points.push_back(fault.point);
  io::write_points(arguments.faults, points, report.columns(), options);
}

}  // namespace

int check_layer(const LayerCheckArguments& arguments) {
  const std::string& path = arguments.input.file;
  check_outputs(arguments);
  io::ReadOptions options;
  options.entries = io::FeatureEntries::all;
  options.vertices = io::RingVertices::all;
  options.threads = arguments.threads;
  JobProgress progress(!arguments.quiet, !arguments.picture.empty());
  const io::Layer layer = read_to_check(arguments.input, options, progress);
  if (layer.regions.contour_ends.empty()) progress.clear();
  if (const auto code = say_no_polygons(path, layer, arguments.json)) return *code;
  const std::vector<std::uint32_t> ends = io::feature_ends(layer);
  const FeatureView features{layer.regions, ends};
  const FaultReport report(layer, features, find_faults(layer, features, arguments, progress));
  if (!arguments.faults.empty()) {
    progress.show(Phase::writing, "writing", 0);
    write_faults(report, layer, arguments);
  }
  if (!arguments.picture.empty()) {
    if (!arguments.faults.empty()) stop_before_more_output();
    progress.show(Phase::drawing, "drawing", 0);
    draw_faults(layer, report.faults(), short_name({&path, 1}), arguments.picture, existing(arguments));
  }
  progress.clear();
  if (arguments.json) {
    fmt::print(
        "{}\n",
        report.to_json(path, arguments.coverage).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  } else {
    fmt::print("{}", report.to_text(arguments.coverage));
    if (!arguments.faults.empty() && arguments.faults != "-")
      fmt::print("wrote {} to {}\n", counted(report.faults().size(), "point"), arguments.faults);
    if (!arguments.picture.empty()) fmt::print("wrote the picture {}\n", arguments.picture);
  }
  return report.has_faults() ? exit_data : exit_done;
}

}  // namespace oblast::app
