// Pictures as files: the extension decides the format.
#pragma once

#include <string>

#include "io/write.h"

namespace oblast::io {

/// Throws IoError if a picture cannot be written to `path` (".svg", ".png", or "-" for SVG on standard output). Call it
/// before the computation.
void check_picture_writable(const std::string& path, Existing existing = Existing::refuse);

/// Writes the text of an SVG as it is, or drawn as PNG, twice as many pixels as the SVG has units. Throws IoError; then
/// an older file at `path` is unchanged.
void write_picture(const std::string& path, const std::string& svg, Existing existing = Existing::refuse);

}  // namespace oblast::io
