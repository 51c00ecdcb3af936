// Through the project's own reader.
#include "apps/rows_support.h"

#include <fmt/format.h>
#include <oblast/region_set.h>

#include "io/rows.h"
#include "verify/rows.h"

namespace oblast::test {

std::string square(double x, double w, const std::string& properties) {
  std::string geometry = "null";
  if (w > 0) {
    geometry = fmt::format(R"({{"type":"Polygon","coordinates":[[[{0},0],[{1},0],[{1},{2}],[{0},{2}],[{0},0]]]}})", x,
                           x + w, w);
  }
  return R"({"type":"Feature","properties":{)" + properties + R"(},"geometry":)" + geometry + "}";
}

void write_layer(const std::filesystem::path& path, const std::vector<std::string>& features) {
  std::string text = R"({"type":"FeatureCollection",)"
                     R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::3035"}},"features":[)";
  for (std::size_t i = 0; i < features.size(); ++i) text += (i ? ",\n" : "\n") + features[i];
  write_file(path, text + "]}");
}

RowsOfFile rows_of(const std::string& path) {
  std::vector<std::string> notes;
  const std::vector<std::string> paths{path};
  const io::Rows rows = io::read_rows(paths, {}, notes);
  RowsOfFile found;
  const auto& columns = rows.table.columns();
  for (const io::Column& column : columns)
    found.columns += (found.columns.empty() ? "" : ", ") + column.name + ": " + io::name(column.type);
  for (std::size_t row = 0; row < rows.table.row_count(); ++row) {
    std::string line;
    for (std::size_t c = 0; c < columns.size(); ++c)
      line += columns[c].name + "=" + (rows.table.is_null(row, c) ? "null" : rows.table.text(row, c)) + " ";
    const bool empty = rows.view().feature_begin(row) == rows.view().feature_end(row);
    const double area = empty ? 0 : signed_area(verify::regions_of(rows.view(), row));
    found.rows.push_back(line + fmt::format("area={}", area));
  }
  return found;
}

double area_of(const std::string& path) {
  std::vector<std::string> notes;
  const std::vector<std::string> paths{path};
  return signed_area(io::read_rows(paths, {}, notes).layer.regions);
}

}  // namespace oblast::test
