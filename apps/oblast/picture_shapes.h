// Lines and points of a layer for pictures, which draw regions.
#pragma once

#include "io/layer.h"

namespace oblast::app {

/// The files and regions of the layer. A line becomes a contour there and back, which is drawn as a line; a point
/// becomes a small square.
io::Layer drawable(const io::Layer& layer);

}  // namespace oblast::app
