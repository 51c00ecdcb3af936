// The limits of the formats; see field_plan.h.
#include "io/field_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "io/formats.h"

namespace oblast::io {

namespace {

enum class Case { matters, ignored };

struct Limits {
  const char* name;
  std::set<ColumnType> types;
  std::set<ColumnSubtype> subtypes;
  std::size_t name_bytes;  // 0: any
  Case names;
  std::size_t longest_text;
};

const Limits& limits_of(const std::string& path) {
  using enum ColumnType;
  using enum ColumnSubtype;
  static const Limits shapefile{"Shapefile", {integer, integer64, real, text, date}, {}, 10, Case::ignored, 254};
  static const Limits geopackage{"GeoPackage",
                                 {integer, integer64, real, text, date, date_time, binary},
                                 {boolean, int16, float32, json},
                                 0,
                                 Case::ignored,
                                 0};
  static const Limits flatgeobuf{"FlatGeobuf",
                                 {integer, integer64, real, text, date_time, binary},
                                 {boolean, int16, float32},
                                 0,
                                 Case::matters,
                                 0};
  static const Limits geojson{
      "GeoJSON",
      {integer, integer64, real, text, date, time, date_time, integer_list, integer64_list, real_list, text_list},
      {boolean, json},
      0,
      Case::matters,
      0};
  static const Limits csv{
      "CSV", {integer, integer64, real, text, date, time, date_time}, {boolean, int16, float32}, 0, Case::ignored, 0};
  static const Limits kml{"KML", {integer, real, text}, {}, 0, Case::ignored, 0};
  static const Limits gml{
      "GML", {integer, integer64, real, text, date, date_time}, {boolean, int16, float32}, 0, Case::matters, 0};
  static const Limits parquet{"Parquet",
                              {integer, integer64, real, text, date, time, date_time, binary},
                              {boolean, int16, float32},
                              0,
                              Case::matters,
                              0};
  const std::string extension = lower_extension(path);
  if (extension == ".csv") return csv;
  if (extension == ".kml") return kml;
  if (extension == ".gml") return gml;
  if (extension == ".parquet") return parquet;
  if (extension == ".shp") return shapefile;
  if (extension == ".gpkg") return geopackage;
  if (extension == ".fgb") return flatgeobuf;
  return geojson;
}

const char* name(ColumnSubtype subtype) {
  constexpr const char* names[] = {"", "boolean", "int16", "float32", "JSON", "UUID"};
  return names[static_cast<int>(subtype)];
}

// The first bytes of UTF-8 text, without a part of a character at the end.
std::string first_bytes(const std::string& text, std::size_t count) {
  if (text.size() <= count) return text;
  while (count > 0 && (static_cast<unsigned char>(text[count]) & 0xC0) == 0x80) --count;
  return text.substr(0, count);
}

class Names {
 public:
  explicit Names(const Limits& limits) : limits_(limits) {}

  std::string unique(const std::string& wanted) {
    const std::size_t most = limits_.name_bytes == 0 ? std::string::npos : limits_.name_bytes;
    std::string name = first_bytes(wanted, most);
    for (int number = 1; !taken_.insert(key(name)).second; ++number) {
      const std::string suffix = fmt::format("_{}", number);
      name = first_bytes(wanted, most == std::string::npos ? most : most - suffix.size()) + suffix;
    }
    return name;
  }
  /// Names that need no change keep it, whatever columns come before.
  bool keep(const std::string& name) {
    return (limits_.name_bytes == 0 || name.size() <= limits_.name_bytes) && taken_.insert(key(name)).second;
  }

 private:
  std::string key(std::string name) const {
    if (limits_.names == Case::ignored) {
      std::transform(name.begin(), name.end(), name.begin(),
                     [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    }
    return name;
  }

  const Limits& limits_;
  std::set<std::string> taken_;
};

void plan_names(const Limits& limits, FieldPlan& plan) {
  Names names(limits);
  std::vector<bool> kept;
  for (const Column& field : plan.fields) kept.push_back(names.keep(field.name));
  for (std::size_t i = 0; i < plan.fields.size(); ++i) {
    if (kept[i]) continue;
    std::string& name = plan.fields[i].name;
    const std::string unique = names.unique(name);
    const bool too_long = limits.name_bytes > 0 && name.size() > limits.name_bytes;
    plan.notes.push_back(fmt::format("{} is written as {} ({})", name, unique,
                                     too_long ? fmt::format("{} names have {} bytes", limits.name, limits.name_bytes)
                                              : "another column has its name"));
    name = unique;
  }
}

// Text takes every type but binary data.
ColumnType replacement(const Column& field, const Limits& limits) {
  if (field.type == ColumnType::date && limits.types.contains(ColumnType::date_time)) return ColumnType::date_time;
  if (field.type != ColumnType::binary) return ColumnType::text;
  throw IoError(
      fmt::format("column {} has binary data, which {} cannot hold; leave it out with --select, or write .gpkg",
                  field.name, limits.name));
}

void plan_type(const std::string& column, Column& field, const Limits& limits, FieldPlan& plan) {
  if (!limits.types.contains(field.type)) {
    const ColumnType type = replacement(field, limits);
    plan.notes.push_back(
        fmt::format("{} is written as {} ({} has no {})", column, name(type), limits.name, name(field.type)));
    field = {field.name, type};
  } else if (field.subtype != ColumnSubtype::none && !limits.subtypes.contains(field.subtype)) {
    plan.notes.push_back(fmt::format("{} is written as {} ({} has no subtype {})", column, name(field.type),
                                     limits.name, name(field.subtype)));
    field.subtype = ColumnSubtype::none;
  }
  if (limits.longest_text == 0) return;
  if (field.type == ColumnType::integer64 && field.width == 0)
    plan.notes.push_back(
        fmt::format("{} is written as a number of 18 digits ({} has no 64-bit integers)", column, limits.name));
  if (field.type == ColumnType::text && field.width > static_cast<int>(limits.longest_text)) field.width = 0;
}

}  // namespace

FieldPlan plan_fields(std::span<const OutputColumn> columns, const std::string& path) {
  const Limits& limits = limits_of(path);
  FieldPlan plan;
  plan.longest_text = limits.longest_text;
  for (const OutputColumn& column : columns) plan.fields.push_back(column.column);
  plan_names(limits, plan);
  for (std::size_t i = 0; i < columns.size(); ++i) plan_type(columns[i].column.name, plan.fields[i], limits, plan);
  return plan;
}

}  // namespace oblast::io
