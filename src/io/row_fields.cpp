// From tables and computed values to fields; see row_fields.h.
#include "io/row_fields.h"

#include <cpl_string.h>
#include <fmt/format.h>
#include <oblast/features.h>

#include "io/attribute_data.h"
#include "io/number_text.h"

namespace oblast::io {

namespace {

template <class Item>
std::string joined(const std::vector<Item>& items) {
  std::string text = "[";
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i) text += ',';
    if constexpr (std::is_same_v<Item, std::string>) {
      text += json_string(items[i]);
    } else if constexpr (std::is_same_v<Item, double>) {
      append_number(text, items[i]);
    } else {
      text += std::to_string(items[i]);
    }
  }
  return text + "]";
}

// The value has the type of the field, unless the format has no lists: then the field is text.
struct SetValue {
  OGRFeature& feature;
  int field;

  bool is_text() const { return feature.GetFieldDefnRef(field)->GetType() == OFTString; }
  void operator()(std::monostate) const { feature.SetFieldNull(field); }
  void operator()(std::int64_t value) const { feature.SetField(field, static_cast<GIntBig>(value)); }
  void operator()(double value) const { feature.SetField(field, value); }
  void operator()(const std::string& value) const { feature.SetField(field, value.c_str()); }
  void operator()(const std::vector<std::int64_t>& items) const {
    if (is_text()) return (*this)(joined(items));
    const std::vector<GIntBig> list(items.begin(), items.end());
    feature.SetField(field, static_cast<int>(list.size()), list.data());
  }
  void operator()(const std::vector<double>& items) const {
    if (is_text()) return (*this)(joined(items));
    feature.SetField(field, static_cast<int>(items.size()), items.data());
  }
  void operator()(const std::vector<std::string>& items) const {
    if (is_text()) return (*this)(joined(items));
    CPLStringList list;
    for (const std::string& item : items) list.AddString(item.c_str());
    feature.SetField(field, list.List());
  }
};

bool is_time(OGRFieldType type) { return type == OFTDate || type == OFTDateTime; }

// The moment, in seconds of UTC if the zone is known.
double moment(const OGRField& field) {
  constexpr int utc = 100, seconds_of_a_unit = 15 * 60;
  tm civil = {};
  civil.tm_year = field.Date.Year - 1900;
  civil.tm_mon = field.Date.Month - 1;
  civil.tm_mday = field.Date.Day;
  civil.tm_hour = field.Date.Hour;
  civil.tm_min = field.Date.Minute;
  const int zone = field.Date.TZFlag > 1 ? (field.Date.TZFlag - utc) * seconds_of_a_unit : 0;
  return static_cast<double>(timegm(&civil) - zone) + static_cast<double>(field.Date.Second);
}

bool same_number(std::int64_t whole, double number) {
  constexpr std::int64_t exact = std::int64_t{1} << 53;
  return -exact <= whole && whole <= exact && static_cast<double>(whole) == number;
}

bool same_value(const OGRFeature& a, int field, const OGRFeature& b, int field_b) {
  const bool null_a = !a.IsFieldSetAndNotNull(field), null_b = field_b < 0 || !b.IsFieldSetAndNotNull(field_b);
  if (null_a || null_b) return null_a == null_b;
  const OGRFieldType type_a = a.GetFieldDefnRef(field)->GetType(), type_b = b.GetFieldDefnRef(field_b)->GetType();
  const auto is_whole = [](OGRFieldType type) { return type == OFTInteger || type == OFTInteger64; };
  if (is_whole(type_a) && is_whole(type_b)) return a.GetFieldAsInteger64(field) == b.GetFieldAsInteger64(field_b);
  if (is_whole(type_a) && type_b == OFTReal)
    return same_number(a.GetFieldAsInteger64(field), b.GetFieldAsDouble(field_b));
  if (type_a == OFTReal) return a.GetFieldAsDouble(field) == b.GetFieldAsDouble(field_b);
  if (type_a == OFTDateTime && type_b == OFTDateTime)
    return moment(*a.GetRawFieldRef(field)) == moment(*b.GetRawFieldRef(field_b));
  return type_a == type_b && field_text(a, field) == field_text(b, field_b);
}

}  // namespace

void RowFields::set_text(OGRFeature& feature, int field, const std::string& text, std::size_t row) const {
  const std::string& name = columns_[field].column.name;
  if (!CPLIsUTF8(text.data(), static_cast<int>(text.size())))
    throw IoError(fmt::format(
        "row {}, column {}: the text is not UTF-8; say the encoding of the input in its .cpg file", row, name));
  if (plan_.longest_text > 0 && text.size() > plan_.longest_text)
    throw IoError(fmt::format("row {}, column {}: the text has {} bytes, but this format holds {}; write .gpkg instead",
                              row, name, text.size(), plan_.longest_text));
  feature.SetField(field, text.c_str());
}

void RowFields::set_from_table(OGRFeature& feature, int field, const OutputColumn& column, std::size_t row) const {
  const std::uint32_t source_row = column.rows[row];
  if (source_row == no_feature) return feature.SetFieldNull(field);
  const auto source = column.table->data().field(source_row, column.index);
  if (!source.feature) return feature.SetFieldNull(field);
  const OGRFieldType from = source.feature->GetFieldDefnRef(source.index)->GetType();
  const OGRFieldType to = feature.GetFieldDefnRef(field)->GetType();
  if (to == OFTString) return set_text(feature, field, field_text(*source.feature, source.index), row);
  if (from == OFTInteger && to == OFTInteger64)
    return feature.SetField(field, source.feature->GetFieldAsInteger64(source.index));
  if (from == OFTInteger && to == OFTReal)
    return feature.SetField(field, source.feature->GetFieldAsDouble(source.index));
  if (from != to && !(is_time(from) && is_time(to)))
    throw IoError(fmt::format("row {}, column {}: GDAL made a field of another type", row, column.column.name));
  feature.SetField(field, source.feature->GetRawFieldRef(source.index));
}

void RowFields::fill(OGRFeature& feature, std::size_t row) const {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const int field = static_cast<int>(i);
    if (columns_[i].table) {
      set_from_table(feature, field, columns_[i], row);
    } else if (const auto* text = std::get_if<std::string>(&columns_[i].values[row])) {
      set_text(feature, field, *text, row);
    } else {
      std::visit(SetValue{feature, field}, columns_[i].values[row]);
    }
  }
}

ChangedValues::ChangedValues(const RowFields& fields, const OGRFeatureDefn& read) : changed_(fields.size(), 0) {
  for (const Column& field : fields.plan().fields) field_read_.push_back(read.GetFieldIndex(field.name.c_str()));
}

void ChangedValues::compare(const OGRFeature& given, const OGRFeature& read) {
  for (std::size_t i = 0; i < changed_.size(); ++i) {
    if (!same_value(given, static_cast<int>(i), read, field_read_[i])) ++changed_[i];
  }
}

std::vector<std::string> ChangedValues::notes(const RowFields& fields) const {
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < changed_.size(); ++i) {
    if (changed_[i] == 0) continue;
    notes.push_back(
        fmt::format("{}: {} of the values read back different from what was given (the format has fewer "
                    "digits, or no difference between empty and null); .gpkg holds them",
                    fields.plan().fields[i].name, changed_[i]));
  }
  return notes;
}

}  // namespace oblast::io
