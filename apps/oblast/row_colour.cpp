#include "oblast/row_colour.h"

#include <algorithm>
#include <limits>

#include "io/row_colours.h"

namespace oblast::app {

namespace {

bool is_null(const io::OutputColumn& column, std::size_t row) {
  if (!column.table) return std::holds_alternative<std::monostate>(column.values[row]);
  return column.rows[row] == no_feature || column.table->is_null(column.rows[row], column.index);
}

double number(const io::OutputColumn& column, std::size_t row) {
  if (is_null(column, row)) return std::numeric_limits<double>::quiet_NaN();
  if (column.table) {
    return io::is_integer(column.column.type)
               ? static_cast<double>(column.table->integer(column.rows[row], column.index))
               : column.table->real(column.rows[row], column.index);
  }
  const io::Value& value = column.values[row];
  const auto* const whole = std::get_if<std::int64_t>(&value);
  return whole ? static_cast<double>(*whole) : std::get<double>(value);
}

std::string text(const io::OutputColumn& column, std::size_t row) {
  if (is_null(column, row)) return {};
  if (column.table) return column.table->text(column.rows[row], column.index);
  const auto* const words = std::get_if<std::string>(&column.values[row]);
  return words ? *words : "(list)";
}

}  // namespace

const io::OutputColumn* find_column(const std::vector<io::OutputColumn>& columns, const std::string& name) {
  const auto it = std::ranges::find_if(columns, [&](const io::OutputColumn& c) { return c.column.name == name; });
  return it == columns.end() ? nullptr : &*it;
}

std::vector<io::PictureClass> colour_classes(const FeatureView& rows, const io::OutputColumn& column) {
  const std::size_t count = rows.feature_count();
  if (io::is_number(column.column.type)) {
    std::vector<double> numbers;
    for (std::size_t row = 0; row < count; ++row) numbers.push_back(number(column, row));
    return io::classes_by_number(rows, numbers);
  }
  std::vector<std::string> texts;
  for (std::size_t row = 0; row < count; ++row) texts.push_back(text(column, row));
  return io::classes_by_text(rows, texts);
}

}  // namespace oblast::app
