// Colours for rows: by the value of a column, safe for colour-blind readers, with a legend; or so that neighbours
// differ.
#pragma once

#include <oblast/features.h>

#include <span>
#include <string>
#include <vector>

#include "io/picture.h"

namespace oblast::io {

/// The classes of a picture by a number for each row: at most seven, of about equally many polygons, from light to
/// dark (the palette `inferno`). Rows with a NaN are left out. REQUIRES: one number for each row.
std::vector<PictureClass> classes_by_number(const FeatureView& rows, std::span<const double> numbers);

/// The classes of a picture by a text for each row: the seven most frequent texts (the palette of Okabe and Ito), and
/// one class for all others. REQUIRES: one text for each row.
std::vector<PictureClass> classes_by_text(const FeatureView& rows, std::span<const std::string> texts);

/// Pale classes such that rows with a common border have different colours, if seven are enough. Each row gets the
/// first colour that no neighbour before it has. Only the last class has the label.
std::vector<PictureClass> classes_by_neighbours(const FeatureView& rows, const std::string& label);

}  // namespace oblast::io
