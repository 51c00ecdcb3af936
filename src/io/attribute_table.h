// The attributes of the rows of a layer: a table with named columns, and a null or a value in each field.
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/layer.h"

namespace oblast::io {

enum class ColumnType {
  integer,
  integer64,
  real,
  text,
  date,
  time,
  date_time,
  binary,
  integer_list,
  integer64_list,
  real_list,
  text_list,
};
/// What a program may assume of the values of a column, in addition to its type.
enum class ColumnSubtype { none, boolean, int16, float32, json, uuid };

struct Column {
  std::string name;
  ColumnType type = ColumnType::text;
  ColumnSubtype subtype = ColumnSubtype::none;
  int width = 0;      ///< 0: any
  int precision = 0;  ///< digits after the point; 0 if it is not set

  friend bool operator==(const Column&, const Column&) = default;
};

/// "a 32-bit integer", for messages.
std::string name(ColumnType type);

class AttributeTable {
 public:
  struct Data;  // has GDAL types: attribute_data.h

  AttributeTable();
  explicit AttributeTable(std::unique_ptr<Data> data);
  ~AttributeTable();
  AttributeTable(AttributeTable&&) noexcept;
  AttributeTable& operator=(AttributeTable&&) noexcept;

  std::size_t row_count() const;
  const std::vector<Column>& columns() const;
  std::optional<std::size_t> find(const std::string& name) const;

  bool is_null(std::size_t row, std::size_t column) const;
  /// REQUIRES of these: the field is not null; the column is of integers (or of numbers, for `real`).
  std::int64_t integer(std::size_t row, std::size_t column) const;
  double real(std::size_t row, std::size_t column) const;
  /// Any type as text: the fewest digits that read back to the same number, ISO 8601, JSON for lists.
  std::string text(std::size_t row, std::size_t column) const;
  /// Numbers are ordered as numbers, text by bytes, dates and times by time. Nulls are equal to each other and last.
  std::weak_ordering compare(std::size_t column, std::size_t row_a, std::size_t row_b) const;

  const Data& data() const { return *data_; }

 private:
  std::unique_ptr<Data> data_;
};

bool is_integer(ColumnType type);
bool is_number(ColumnType type);
bool is_list(ColumnType type);

}  // namespace oblast::io
