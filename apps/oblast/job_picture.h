// What --svg draws of a job: operands and result.
#pragma once

#include <oblast/region_set.h>

#include <span>
#include <string>
#include <vector>

#include "io/layer.h"
#include "io/picture.h"
#include "io/write.h"

namespace oblast::app {

/// What a picture shows: the operands, one or two, the result, and its name ("difference"). Lines and points are those
/// of the first operand.
struct JobPicture {
  std::vector<const io::Layer*> layers;
  std::vector<std::vector<std::string>> operands;  ///< paths
  RegionView result;
  std::string operation;
  std::vector<io::PictureClass> classes;  ///< if there are any, in place of the operands
};
/// Throws IoError.
void draw(const JobPicture& job, const std::string& path, io::Existing existing);

/// "fires" for one path, "fires and 3 more" for several.
std::string short_name(std::span<const std::string> paths);

/// How the coordinates of the layers are drawn, and their unit.
void set_plane(io::Picture& picture, std::span<const io::Layer* const> layers);

}  // namespace oblast::app
