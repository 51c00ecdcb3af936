// The faults of a file, each at its place, as a picture.
#pragma once

#include <oblast/check_features.h>

#include <span>
#include <string>

#include "io/layer.h"
#include "io/write.h"

namespace oblast::app {

/// Draws the features pale, and a dot for each fault in a colour for its kind; notes are grey. `name` is that of the
/// file, for the title. Throws IoError.
void draw_faults(const io::Layer& layer, std::span<const FeatureFault> faults, const std::string& name,
                 const std::string& path, io::Existing existing);

}  // namespace oblast::app
