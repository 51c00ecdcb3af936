// What an attribute table is made of: GDAL's features without geometry. Only for use inside src/io.
#pragma once

#include <ogrsf_frmts.h>

#include <memory>
#include <string>
#include <vector>

#include "io/attribute_table.h"

namespace oblast::io {

struct AttributeTable::Data {
  /// The rows of one layer of one file, [first_row, the first row of the next part).
  struct Part {
    std::size_t first_row = 0;
    std::vector<int> field_of_column;  ///< -1: the file does not have the column
  };
  std::vector<Column> columns;
  std::vector<Part> parts;
  std::vector<std::unique_ptr<OGRFeature>> rows;  ///< null for the rows of WKT, which have no attributes

  /// A field of a row, or no field. `feature` is null if the value is null.
  struct Field {
    const OGRFeature* feature = nullptr;
    int index = -1;
  };
  Field field(std::size_t row, std::size_t column) const;
};

OGRFieldType field_type(ColumnType type);
OGRFieldSubType field_subtype(ColumnSubtype subtype);
Column column_of(const OGRFieldDefn& field);
void define(OGRFieldDefn& field, const Column& column);

/// See AttributeTable::text. REQUIRES: the field is not null.
std::string field_text(const OGRFeature& feature, int field);
/// A list as a JSON array. REQUIRES: the field is a list and not null.
std::string list_text(const OGRFeature& feature, int field);
/// Text as a JSON string, with its quotes.
std::string json_string(const std::string& text);

}  // namespace oblast::io
