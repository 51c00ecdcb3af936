// Reads any number of files as one operand: lists them, reads them in parallel, and joins them in the order of the
// list.
#include "io/read.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>

#include "io/crs.h"
#include "io/formats.h"
#include "io/gdal_reader.h"
#include "io/paths.h"

namespace oblast::io {

namespace {

Layer read_one(const std::string& path, const ReadOptions& options) {
  if (!options.where.empty() && is_wkt(path))
    throw IoError((path == "-" ? "standard input" : path) + " is WKT, which has no attributes for a condition");
  if (path == "-") return read_wkt(read_text(path), "standard input", options);
  if (is_wkt(path)) return read_wkt(read_text(path), path, options);
  return read_with_gdal(path, options);
}

// Reads each file into a layer. If several files are faulty, the first one in the list is reported, whatever the order
// in which threads read them.
std::vector<Layer> read_each(const std::vector<std::string>& files, const ReadOptions& options) {
  std::vector<Layer> layers(files.size());
  std::vector<std::exception_ptr> failures(files.size());
  std::atomic<std::size_t> first_failure = files.size();
  std::mutex progress_lock;
  std::size_t done = 0;

  const auto read_file = [&](std::size_t i) {
    if (i > first_failure) return;
    try {
      layers[i] = read_one(files[i], options);
      if (options.progress) {
        const std::lock_guard lock(progress_lock);
        options.progress(++done, files.size());
      }
    } catch (...) {
      failures[i] = std::current_exception();
      std::size_t first = first_failure;
      while (i < first && !first_failure.compare_exchange_weak(first, i)) {
      }
    }
  };
  // More threads than cores would gain nothing, and TBB would say so on standard error.
  const int cores = tbb::info::default_concurrency();
  tbb::task_arena arena(options.threads > 0 ? std::min(options.threads, cores) : cores);
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, files.size(), read_file); });
  if (first_failure < files.size()) std::rethrow_exception(failures[first_failure]);
  return layers;
}

void add(ReadReport& sum, const ReadReport& part) {
  sum.features += part.features;
  sum.null_geometries += part.null_geometries;
  sum.empty_geometries += part.empty_geometries;
  sum.lines += part.lines;
  sum.points += part.points;
  sum.with_z += part.with_z;
  sum.with_m += part.with_m;
  sum.unclosed_contours += part.unclosed_contours;
  sum.repeated_vertices += part.repeated_vertices;
}

void append(Layer& sum, const Layer& part) {
  const auto points = static_cast<std::uint32_t>(sum.regions.points.size());
  const auto contours = static_cast<std::uint32_t>(sum.regions.contour_ends.size());
  const auto polygons = static_cast<std::uint32_t>(sum.regions.polygon_ends.size());
  const auto files = static_cast<std::uint32_t>(sum.files.size());
  const RegionSet& regions = part.regions;
  sum.regions.points.insert(sum.regions.points.end(), regions.points.begin(), regions.points.end());
  for (const std::uint32_t end : regions.contour_ends) sum.regions.contour_ends.push_back(points + end);
  for (const std::uint32_t end : regions.polygon_ends) sum.regions.polygon_ends.push_back(contours + end);
  for (FeatureRange feature : part.features) {
    feature.first_polygon += polygons;
    feature.file += files;
    sum.features.push_back(feature);
  }
  for (const std::uint32_t contour : part.open_contours) sum.open_contours.push_back(contours + contour);
  sum.files.insert(sum.files.end(), part.files.begin(), part.files.end());
  add(sum.report, part.report);
}

void reserve(RegionSet& regions, const std::vector<Layer>& layers) {
  std::size_t points = 0, contours = 0, polygons = 0;
  for (const Layer& layer : layers) {
    points += layer.regions.points.size();
    contours += layer.regions.contour_ends.size();
    polygons += layer.regions.polygon_ends.size();
  }
  if (points > std::numeric_limits<std::int32_t>::max()) throw IoError("more than 2^31 - 1 vertices in one operand");
  regions.points.reserve(points);
  regions.contour_ends.reserve(contours);
  regions.polygon_ends.reserve(polygons);
}

}  // namespace

Layer read(std::span<const std::string> paths, const ReadOptions& options) {
  std::vector<Layer> layers = read_each(expand_paths(paths), options);
  CommonCrs crs;
  for (const Layer& layer : layers) crs.add(layer.crs_wkt, layer.files.front());
  if (layers.size() == 1) return std::move(layers.front());

  Layer sum;
  reserve(sum.regions, layers);
  for (Layer& layer : layers) {
    append(sum, layer);
    layer = {};  // frees its memory
  }
  sum.crs_wkt = crs.wkt();
  return sum;
}

}  // namespace oblast::io
