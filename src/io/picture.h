// SVG pictures a person can judge.
#pragma once

#include <string>

#include <oblast/region_set.h>

#include "io/write.h"

namespace oblast::io {

struct Picture {
  RegionView a;       ///< first operand, translucent
  RegionView b;       ///< second operand, another translucent colour; may be empty
  RegionView result;  ///< outlined
  std::string title;
  std::string label_a = "A";
  std::string label_b = "B";
  std::string label_result = "result";
};

/// Writes an SVG with a legend. However large the input, the file stays within a few MB: what is
/// smaller than a pixel at the picture's size is simplified away or gathered. Throws IoError.
void write_svg(const std::string& path, const Picture& picture, Existing existing = Existing::refuse);

}  // namespace oblast::io
