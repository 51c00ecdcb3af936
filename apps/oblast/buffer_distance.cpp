#include "oblast/buffer_distance.h"

#include <fmt/format.h>

#include <cmath>

#include "oblast/command.h"
#include "oblast/row_job.h"

namespace oblast::app {

Distance parse_distance(const std::string& word) {
  if (const std::optional<Length> length = parse_length(word)) {
    if (length->unit == "%") throw CallError(fmt::format("'{}': a distance is no percentage; write 500m or 30", word));
    return {length, {}};
  }
  return {{}, word};
}

std::vector<double> distances(const Distance& distance, const io::Rows& rows, const io::CoordinateUnit& unit) {
  if (distance.length) return {in_units(*distance.length, unit)};
  const io::AttributeTable& table = rows.table;
  const std::string& name = distance.column;
  if (!table.find(name)) {
    std::string numeric;
    for (const io::Column& column : table.columns())
      if (io::is_number(column.type)) numeric += (numeric.empty() ? "" : ", ") + column.name;
    throw io::IoError(fmt::format(
        "--distance {0}: {1} has no column {0}; give a number with a unit, such as 500m, or a column of numbers ({2})",
        name, rows.layer.files.front(), numeric.empty() ? "there is none" : numeric));
  }
  const std::size_t column = *table.find(name);
  if (!io::is_number(table.columns()[column].type))
    throw io::IoError(
        fmt::format("--distance {0}: column {0} has {1}, not a number", name, io::name(table.columns()[column].type)));
  std::vector<double> values;
  values.reserve(table.row_count());
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const io::FeatureRange& feature = rows.layer.features[row];
    const double value = table.is_null(row, column) ? std::nan("") : table.real(row, column);
    if (!std::isfinite(value))
      throw io::IoError(
          fmt::format("{}, feature {}: there is no distance in column {}; leave such features out with "
                      "--where \"{} IS NOT NULL\"",
                      rows.layer.files[feature.file], feature.feature, name, name));
    values.push_back(value);
  }
  return values;
}

Tolerance parse_tolerance(const std::string& word) {
  constexpr double least = 1e-9, most = 0.5, percent = 0.01;
  const std::optional<Length> given = parse_length(word);
  if (!given)
    throw CallError(fmt::format("--tolerance '{}': write a share such as 0.01 or 1%, or a length such as 0.5m", word));
  Tolerance tolerance{*given};
  if (given->unit == "%") tolerance.length = {given->number * percent, ""};
  const double number = tolerance.length.number;
  if (!tolerance.is_absolute() && !(number >= least && number <= most))
    throw CallError(fmt::format(
        "--tolerance {}: a share of the distance must be from 1e-9 to 0.5 (50%); for a length add its unit, such as "
        "0.5m, or `units` for that of the coordinates",
        word));
  if (!(number > 0)) throw CallError(fmt::format("--tolerance {}: it must be above 0", word));
  return tolerance;
}

void set_tolerance(BufferOptions& options, const Tolerance& tolerance, const io::CoordinateUnit& unit) {
  if (tolerance.is_absolute()) {
    options.absolute_tolerance = in_units(tolerance.length, unit);
  } else {
    options.tolerance = tolerance.length.number;
  }
}

}  // namespace oblast::app
