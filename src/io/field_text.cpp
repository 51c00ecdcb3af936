// Fields as text; see attribute_data.h.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "io/attribute_data.h"
#include "io/number_text.h"

namespace oblast::io {

namespace {

std::string number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

// JSON has no infinities and no NaN.
std::string json_number(double value) { return std::isfinite(value) ? number(value) : "null"; }

template <class Items, class Print>
std::string array(const Items& items, int count, const Print& print) {
  std::string text = "[";
  for (int i = 0; i < count; ++i) text += (i ? "," : "") + print(items[i]);
  return text + "]";
}

// 5.25 s as "05.25": the field has milliseconds as a float.
std::string seconds_text(float seconds) {
  const int milliseconds = static_cast<int>(std::lround(seconds * 1000));
  std::string text = fmt::format("{:02}", milliseconds / 1000);
  if (milliseconds % 1000) text += fmt::format(".{:03}", milliseconds % 1000);
  return text;
}

std::string date_text(const OGRField& field) {
  return fmt::format("{:04}-{:02}-{:02}", field.Date.Year, field.Date.Month, field.Date.Day);
}
std::string time_text(const OGRField& field) {
  return fmt::format("{:02}:{:02}:{}", field.Date.Hour, field.Date.Minute, seconds_text(field.Date.Second));
}

// TZFlag: 0 unknown, 1 local time, 100 UTC, and a unit more for each quarter of an hour east of it.
std::string zone_text(const OGRField& field) {
  constexpr int utc = 100, minutes_of_a_unit = 15;
  if (field.Date.TZFlag <= 1) return {};
  const int minutes = (field.Date.TZFlag - utc) * minutes_of_a_unit;
  if (minutes == 0) return "Z";
  return fmt::format("{}{:02}:{:02}", minutes < 0 ? '-' : '+', std::abs(minutes) / 60, std::abs(minutes) % 60);
}

}  // namespace

std::string json_string(const std::string& text) {
  std::string json = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      json += '\\';
      json += c;
    } else if (c == '\n') {
      json += "\\n";
    } else if (c == '\t') {
      json += "\\t";
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      json += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      json += c;
    }
  }
  return json + "\"";
}

std::string list_text(const OGRFeature& feature, int field) {
  int count = 0;
  const auto plain = [](auto value) { return std::to_string(value); };
  switch (feature.GetFieldDefnRef(field)->GetType()) {
    case OFTIntegerList: {
      const int* items = feature.GetFieldAsIntegerList(field, &count);
      return array(items, count, plain);
    }
    case OFTInteger64List: {
      const GIntBig* items = feature.GetFieldAsInteger64List(field, &count);
      return array(items, count, plain);
    }
    case OFTRealList: {
      const double* items = feature.GetFieldAsDoubleList(field, &count);
      return array(items, count, json_number);
    }
    default: {
      char** items = feature.GetFieldAsStringList(field);
      while (items && items[count]) ++count;
      return array(items, count, [](const char* item) { return json_string(item); });
    }
  }
}

std::string field_text(const OGRFeature& feature, int field) {
  const OGRField& raw = *feature.GetRawFieldRef(field);
  switch (feature.GetFieldDefnRef(field)->GetType()) {
    case OFTInteger:
      return std::to_string(raw.Integer);
    case OFTInteger64:
      return std::to_string(raw.Integer64);
    case OFTReal:
      return number(raw.Real);
    case OFTString:
      return raw.String;
    case OFTDate:
      return date_text(raw);
    case OFTTime:
      return time_text(raw);
    case OFTDateTime:
      return date_text(raw) + "T" + time_text(raw) + zone_text(raw);
    case OFTIntegerList:
    case OFTInteger64List:
    case OFTRealList:
    case OFTStringList:
      return list_text(feature, field);
    default:
      return const_cast<OGRFeature&>(feature).GetFieldAsString(field);  // binary: hexadecimal
  }
}

}  // namespace oblast::io
