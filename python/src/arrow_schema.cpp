#include <cstdlib>
#include <cstring>
#include <string_view>

#include "arrow_geometry.h"

namespace oblast::python {

namespace {

using std::string_view;

// The value of a key in the metadata of a field: counts and lengths of 32 bits, then the bytes.
std::string metadata_of(const ArrowSchema& schema, string_view wanted) {
  const char* at = schema.metadata;
  if (at == nullptr) return {};
  const auto number = [&] {
    std::int32_t value = 0;
    std::memcpy(&value, at, sizeof value);
    at += sizeof value;
    return value;
  };
  const auto text = [&] {
    const auto length = static_cast<std::size_t>(number());
    const string_view value(at, length);
    at += length;
    return value;
  };
  for (std::int32_t left = number(); left > 0; --left) {
    const string_view key = text(), value = text();
    if (key == wanted) return std::string(value);
  }
  return {};
}

bool is_list(const ArrowSchema& schema) {
  const string_view format = schema.format;
  return (format == "+l" || format == "+L") && schema.n_children == 1;
}

bool is_binary(const ArrowSchema& schema) {
  const string_view format = schema.format;
  return format == "z" || format == "Z";
}

// The depth of the lists above the coordinates, or -1 if it is no such column.
int list_depth(const ArrowSchema& schema) {
  int depth = 0;
  const ArrowSchema* inner = &schema;
  for (; is_list(*inner); ++depth) inner = inner->children[0];
  const string_view format = inner->format;
  const bool fixed =
      format.substr(0, 3) == "+w:" && inner->n_children == 1 && string_view(inner->children[0]->format) == "g";
  const bool separate = format == "+s" && inner->n_children >= 2 && string_view(inner->children[0]->format) == "g";
  return fixed || separate ? depth : -1;
}

bool is_geometry(const ArrowSchema& schema) {
  const std::string extension = metadata_of(schema, "ARROW:extension:name");
  if (extension == "geoarrow.wkb" || extension == "ogc.wkb" || extension == "geoarrow.polygon" ||
      extension == "geoarrow.multipolygon")
    return true;
  if (!extension.empty()) return false;
  const int depth = list_depth(schema);
  return depth == 2 || depth == 3 || (is_binary(schema) && string_view(schema.name ? schema.name : "") == "geometry");
}

GeometryColumn described(const ArrowSchema& schema) {
  GeometryColumn column;
  column.metadata = metadata_of(schema, "ARROW:extension:metadata");
  if (is_binary(schema)) {
    column.encoding = Encoding::wkb;
    column.large = *schema.format == 'Z';
    return column;
  }
  const int depth = list_depth(schema);
  if (depth != 2 && depth != 3) {
    const std::string extension = metadata_of(schema, "ARROW:extension:name");
    throw nb::type_error(("not a column of polygons: its Arrow format is '" + std::string(schema.format) + "'" +
                          (extension.empty() ? "" : ", its extension " + extension) +
                          "; expected geoarrow.polygon, geoarrow.multipolygon or geoarrow.wkb")
                             .c_str());
  }
  column.encoding = depth == 2 ? Encoding::polygon : Encoding::multipolygon;
  const ArrowSchema* inner = &schema;
  for (int i = 0; i < depth; ++i) {
    column.large_lists.push_back(inner->format[1] == 'L');
    inner = inner->children[0];
  }
  column.interleaved = inner->format[1] == 'w';
  column.dimensions = column.interleaved ? std::atoi(inner->format + 3) : static_cast<int>(inner->n_children);
  if (column.dimensions < 2) throw nb::type_error("a coordinate must have two numbers or more");
  return column;
}

}  // namespace

GeometryColumn geometry_column(const ArrowSchema& schema, const std::string& name) {
  if (string_view(schema.format) != "+s" || is_geometry(schema)) return described(schema);
  int found = -1;
  for (int c = 0; c < schema.n_children; ++c) {
    const string_view child = schema.children[c]->name ? schema.children[c]->name : "";
    if (!name.empty() ? child != name : !is_geometry(*schema.children[c])) continue;
    if (found >= 0) throw nb::type_error("the table has several geometry columns: name one by column=");
    found = c;
  }
  if (found < 0)
    throw nb::type_error(name.empty() ? "the table has no geometry column; name it by column="
                                      : ("the table has no column " + name).c_str());
  GeometryColumn column = described(*schema.children[found]);
  column.child = found;
  return column;
}

}  // namespace oblast::python
