// Colours of rows in pictures, from the values of a column.
#pragma once

#include <oblast/features.h>

#include <string>
#include <vector>

#include "io/picture.h"
#include "io/row_columns.h"

namespace oblast::app {

/// The column of this name, or null.
const io::OutputColumn* find_column(const std::vector<io::OutputColumn>& columns, const std::string& name);

/// By numbers if the column has numbers (rows with nulls are left out), else by text.
std::vector<io::PictureClass> colour_classes(const FeatureView& rows, const io::OutputColumn& column);

}  // namespace oblast::app
