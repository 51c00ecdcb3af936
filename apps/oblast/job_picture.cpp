#include "oblast/job_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "io/picture_file.h"
#include "io/row_measures.h"
#include "oblast/console.h"

namespace oblast::app {

std::string short_name(std::span<const std::string> paths) {
  std::string path = paths.front();
  while (path.size() > 1 && path.back() == '/') path.pop_back();
  std::string text = path == "-" ? "standard input" : std::filesystem::path(path).filename().string();
  if (paths.size() > 1) text += fmt::format(" and {} more", paths.size() - 1);
  return text;
}

void set_plane(io::Picture& picture, std::span<const io::Layer* const> layers) {
  const std::string& crs = layers.front()->crs_wkt.empty() ? layers.back()->crs_wkt : layers.front()->crs_wkt;
  // Coordinates beyond the poles are no longitudes and latitudes, whatever the file says; there is a warning then.
  const bool in_degrees =
      crs.rfind("GEOG", 0) == 0 &&
      std::all_of(layers.begin(), layers.end(), [](const io::Layer* layer) { return layer->report.beyond_pole == 0; });
  if (in_degrees) picture.projection = io::MapProjection::longitude_latitude;
  const io::RowMeasures measures(crs);
  if (!measures.geodesic()) picture.unit = measures.coordinate_unit();
}

void draw(const JobPicture& job, const std::string& path, io::Existing existing) {
  io::Picture picture;
  const bool two = job.layers.size() > 1;
  picture.a = job.layers[0]->regions;
  picture.label_a = short_name(job.operands[0]);
  if (two) {
    picture.b = job.layers[1]->regions;
    picture.label_b = short_name(job.operands[1]);
  }
  picture.result = job.result;
  const io::LinesAndPoints& others = job.layers[0]->others;
  picture.lines = {others.line_vertices, others.line_ends};
  if (!others.points.empty())
    picture.marks.push_back(
        {others.points, io::colour_of_lines, picture.label_a + ": " + counted(others.points.size(), "point"), 3});
  picture.label_result = job.operation;
  picture.title = two ? fmt::format("{} of {} and {}", job.operation, picture.label_a, picture.label_b)
                      : fmt::format("{} of {}", job.operation, picture.label_a);
  picture.classes = job.classes;
  set_plane(picture, job.layers);
  io::write_picture(path, io::to_svg(picture), existing);
}

}  // namespace oblast::app
