// Columns and fields; see attribute_table.h.
#include "io/attribute_table.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <tuple>

#include "io/attribute_data.h"

namespace oblast::io {

namespace {

struct TypeName {
  ColumnType type;
  OGRFieldType field;
  const char* name;
};
constexpr TypeName types[] = {
    {ColumnType::integer, OFTInteger, "32-bit integers"},
    {ColumnType::integer64, OFTInteger64, "64-bit integers"},
    {ColumnType::real, OFTReal, "numbers"},
    {ColumnType::text, OFTString, "text"},
    {ColumnType::date, OFTDate, "dates"},
    {ColumnType::time, OFTTime, "times"},
    {ColumnType::date_time, OFTDateTime, "dates with time"},
    {ColumnType::binary, OFTBinary, "binary data"},
    {ColumnType::integer_list, OFTIntegerList, "lists of 32-bit integers"},
    {ColumnType::integer64_list, OFTInteger64List, "lists of 64-bit integers"},
    {ColumnType::real_list, OFTRealList, "lists of numbers"},
    {ColumnType::text_list, OFTStringList, "lists of text"},
};
constexpr std::pair<ColumnSubtype, OGRFieldSubType> subtypes[] = {
    {ColumnSubtype::none, OFSTNone},       {ColumnSubtype::boolean, OFSTBoolean}, {ColumnSubtype::int16, OFSTInt16},
    {ColumnSubtype::float32, OFSTFloat32}, {ColumnSubtype::json, OFSTJSON},       {ColumnSubtype::uuid, OFSTUUID},
};

auto time_of(const OGRField& field) {
  const auto& d = field.Date;
  return std::tuple(d.Year, d.Month, d.Day, d.Hour, d.Minute, d.Second, d.TZFlag);
}

template <class Value>
std::weak_ordering order(const Value& a, const Value& b) {
  if (a < b) return std::weak_ordering::less;
  return b < a ? std::weak_ordering::greater : std::weak_ordering::equivalent;
}

// Not a number is after all numbers.
std::weak_ordering order_of_numbers(double a, double b) {
  if (a != a || b != b) return order(a != a, b != b);
  return order(a, b);
}

AttributeTable::Data::Field value_field(const AttributeTable::Data& data, std::size_t row, std::size_t column) {
  const auto field = data.field(row, column);
  if (!field.feature) throw std::logic_error("a null has no value");
  return field;
}

}  // namespace

OGRFieldType field_type(ColumnType type) { return types[static_cast<int>(type)].field; }
std::string name(ColumnType type) { return types[static_cast<int>(type)].name; }
OGRFieldSubType field_subtype(ColumnSubtype subtype) { return subtypes[static_cast<int>(subtype)].second; }

Column column_of(const OGRFieldDefn& field) {
  Column column{field.GetNameRef(), ColumnType::text, ColumnSubtype::none, field.GetWidth(), field.GetPrecision()};
  for (const TypeName& type : types) {
    if (type.field == field.GetType()) column.type = type.type;
  }
  for (const auto& [subtype, gdal] : subtypes) {
    if (gdal == field.GetSubType()) column.subtype = subtype;
  }
  return column;
}

void define(OGRFieldDefn& field, const Column& column) {
  field.SetName(column.name.c_str());
  field.SetType(field_type(column.type));
  field.SetSubType(field_subtype(column.subtype));
  field.SetWidth(column.width);
  field.SetPrecision(column.precision);
}

bool is_integer(ColumnType type) { return type == ColumnType::integer || type == ColumnType::integer64; }
bool is_number(ColumnType type) { return is_integer(type) || type == ColumnType::real; }
bool is_list(ColumnType type) { return type >= ColumnType::integer_list; }

AttributeTable::AttributeTable() : data_(std::make_unique<Data>()) {}
AttributeTable::AttributeTable(std::unique_ptr<Data> data) : data_(std::move(data)) {}
AttributeTable::~AttributeTable() = default;
AttributeTable::AttributeTable(AttributeTable&&) noexcept = default;
AttributeTable& AttributeTable::operator=(AttributeTable&&) noexcept = default;

std::size_t AttributeTable::row_count() const { return data_->rows.size(); }
const std::vector<Column>& AttributeTable::columns() const { return data_->columns; }

std::optional<std::size_t> AttributeTable::find(const std::string& name) const {
  for (std::size_t c = 0; c < columns().size(); ++c) {
    if (columns()[c].name == name) return c;
  }
  return std::nullopt;
}

AttributeTable::Data::Field AttributeTable::Data::field(std::size_t row, std::size_t column) const {
  const OGRFeature* feature = rows[row].get();
  if (!feature) return {};
  const auto after = std::upper_bound(parts.begin(), parts.end(), row,
                                      [](std::size_t r, const Part& part) { return r < part.first_row; });
  const int index = (after - 1)->field_of_column[column];
  if (index < 0 || !feature->IsFieldSetAndNotNull(index)) return {};
  return {feature, index};
}

bool AttributeTable::is_null(std::size_t row, std::size_t column) const { return !data_->field(row, column).feature; }

std::int64_t AttributeTable::integer(std::size_t row, std::size_t column) const {
  const Data::Field field = value_field(*data_, row, column);
  return field.feature->GetFieldAsInteger64(field.index);
}

double AttributeTable::real(std::size_t row, std::size_t column) const {
  const Data::Field field = value_field(*data_, row, column);
  return field.feature->GetFieldAsDouble(field.index);
}

std::string AttributeTable::text(std::size_t row, std::size_t column) const {
  const Data::Field field = value_field(*data_, row, column);
  return field_text(*field.feature, field.index);
}

std::weak_ordering AttributeTable::compare(std::size_t column, std::size_t row_a, std::size_t row_b) const {
  const Data::Field a = data_->field(row_a, column), b = data_->field(row_b, column);
  if (!a.feature || !b.feature) return order(!a.feature, !b.feature);
  const ColumnType type = columns()[column].type;
  if (is_integer(type)) return order(a.feature->GetFieldAsInteger64(a.index), b.feature->GetFieldAsInteger64(b.index));
  if (type == ColumnType::real)
    return order_of_numbers(a.feature->GetFieldAsDouble(a.index), b.feature->GetFieldAsDouble(b.index));
  if (type == ColumnType::date || type == ColumnType::time || type == ColumnType::date_time)
    return order(time_of(*a.feature->GetRawFieldRef(a.index)), time_of(*b.feature->GetRawFieldRef(b.index)));
  const auto is_text = [](const Data::Field& f) { return f.feature->GetFieldDefnRef(f.index)->GetType() == OFTString; };
  if (is_text(a) && is_text(b)) {  // without copies
    const auto text = [](const Data::Field& f) { return std::string_view(f.feature->GetRawFieldRef(f.index)->String); };
    return order(text(a), text(b));
  }
  return order(field_text(*a.feature, a.index), field_text(*b.feature, b.index));
}

}  // namespace oblast::io
