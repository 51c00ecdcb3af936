// Rows are made in parallel, in batches, and stored in their order; see geopackage_writer.h.
#include "io/geopackage_writer.h"

#include <fmt/format.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <utility>

#include "io/attribute_data.h"
#include "io/geopackage_index.h"
#include "io/sqlite_file.h"

namespace oblast::io {

namespace {

constexpr std::size_t batch_size = 1024;  // rows

struct Row {
  std::unique_ptr<OGRFeature> fields;
  std::vector<unsigned char> blob;  // empty: no geometry
  Box box = {};
};

struct Batch {
  std::size_t first = 0;
  std::vector<Row> rows;
};

// Parts of the whole, roughly: rows, index, reading back.
constexpr double rows_end = 0.5, index_end = 0.7;

// Makes all rows on all cores, and hands batches to `take` in their order. It is the stretch [from, to] of the whole.
template <class Take>
void for_all_batches(const GeopackageRows& output, std::int32_t srs_id, double from, double to, const Take& take) {
  const std::size_t rows = output.rows.feature_count(), count = (rows + batch_size - 1) / batch_size;
  const std::size_t tokens = 4 * static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  // oneTBB loses what its tokens own when a filter throws. So tokens are numbers, and batches are kept here: as the
  // last filter is in order, a batch is taken before the number comes that uses its place again.
  std::vector<Batch> batches(std::min(tokens, count));
  std::size_t next = 0;
  const auto begin = [&](tbb::flow_control& control) {
    if (next >= count) control.stop();
    return next++;
  };
  const auto make = [&](std::size_t number) {
    Batch& batch = batches[number % tokens];
    batch = {number * batch_size, {}};
    batch.rows.resize(std::min(batch_size, rows - batch.first));
    for (std::size_t i = 0; i < batch.rows.size(); ++i) {
      Row& row = batch.rows[i];
      row.fields = std::make_unique<OGRFeature>(&output.definition);
      output.fields.fill(*row.fields, batch.first + i);
      if (output.rows.feature_begin(batch.first + i) < output.rows.feature_end(batch.first + i))
        geopackage_blob(output.rows, batch.first + i, output.shape, srs_id, row.blob, row.box);
    }
    return number;
  };
  const auto last = [&](std::size_t number) {
    const Batch batch = std::exchange(batches[number % tokens], {});
    take(batch);
    const double share = static_cast<double>(batch.first + batch.rows.size()) / static_cast<double>(rows);
    if (output.progress) output.progress(from + (to - from) * share);
  };
  using Mode = tbb::filter_mode;
  tbb::parallel_pipeline(tokens, tbb::make_filter<void, std::size_t>(Mode::serial_in_order, begin) &
                                     tbb::make_filter<std::size_t, std::size_t>(Mode::parallel, make) &
                                     tbb::make_filter<std::size_t, void>(Mode::serial_in_order, last));
}

std::string date_text(const OGRFeature& feature, int field) {
  const auto& date = feature.GetRawFieldRef(field)->Date;
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.Year), static_cast<int>(date.Month),
                     static_cast<int>(date.Day));
}

void bind_field(SqliteStatement& insert, int parameter, const OGRFeature& feature, int field, std::string& scratch) {
  if (!feature.IsFieldSetAndNotNull(field)) return insert.bind_null(parameter);
  switch (feature.GetFieldDefnRef(field)->GetType()) {
    case OFTInteger:
    case OFTInteger64:
      return insert.bind(parameter, static_cast<std::int64_t>(feature.GetFieldAsInteger64(field)));
    case OFTReal:
      return insert.bind(parameter, feature.GetFieldAsDouble(field));
    case OFTDate:
      scratch = date_text(feature, field);
      return insert.bind_text(parameter, scratch.c_str());
    default:
      return insert.bind_text(parameter, feature.GetFieldAsString(field));
  }
}

enum class Found { same, lost, other };

Found compare(sqlite3_stmt* row, int column, const OGRFeature& feature, int field) {
  const bool is_null = sqlite3_column_type(row, column) == SQLITE_NULL;
  if (!feature.IsFieldSetAndNotNull(field)) return is_null ? Found::same : Found::other;
  const auto same_text = [&](const char* text) {
    const auto* read = reinterpret_cast<const char*>(sqlite3_column_text(row, column));
    return read && std::strcmp(read, text) == 0 ? Found::same : Found::other;
  };
  switch (feature.GetFieldDefnRef(field)->GetType()) {
    case OFTInteger:
    case OFTInteger64:
      return sqlite3_column_int64(row, column) == feature.GetFieldAsInteger64(field) && !is_null ? Found::same
                                                                                                 : Found::other;
    case OFTReal: {
      const double value = feature.GetFieldAsDouble(field);
      if (std::isnan(value)) return is_null ? Found::lost : Found::other;
      return sqlite3_column_double(row, column) == value && !is_null ? Found::same : Found::other;
    }
    case OFTDate:
      return same_text(date_text(feature, field).c_str());
    default:
      return same_text(feature.GetFieldAsString(field));
  }
}

// The columns of the table: id, geometry, attributes.
std::vector<std::string> column_names(const GeopackageRows& output) {
  std::vector<std::string> names{sql_name(output.id_column), sql_name(output.geometry_column)};
  for (const Column& field : output.fields.plan().fields) names.push_back(sql_name(field.name));
  return names;
}

std::string insert_text(const GeopackageRows& output) {
  const std::vector<std::string> names = column_names(output);
  std::string marks = "?";
  for (std::size_t i = 1; i < names.size(); ++i) marks += ", ?";
  return fmt::format("INSERT INTO {} ({}) VALUES ({})", sql_name(output.what.layer), fmt::join(names, ", "), marks);
}

std::int32_t srs_of_layer(SqliteFile& file, const std::string& layer) {
  SqliteStatement find(file, "SELECT srs_id FROM gpkg_geometry_columns WHERE table_name = ?");
  find.bind_text(1, layer.c_str());
  if (!find.step()) file.fail();
  return sqlite3_column_int(find.get(), 0);
}

void set_counts(SqliteFile& file, const GeopackageRows& output, const std::vector<IndexedBox>& boxes) {
  const char* const layer = output.what.layer.c_str();
  SqliteStatement count(file, "UPDATE gpkg_ogr_contents SET feature_count = ? WHERE table_name = ?");
  count.bind(1, static_cast<std::int64_t>(output.rows.feature_count()));
  count.bind_text(2, layer);
  count.run();
  if (boxes.empty()) return;
  Box all = boxes.front().box;
  for (const IndexedBox& indexed : boxes) {
    all = {std::min(all.x0, indexed.box.x0), std::min(all.y0, indexed.box.y0), std::max(all.x1, indexed.box.x1),
           std::max(all.y1, indexed.box.y1)};
  }
  SqliteStatement extent(file,
                         "UPDATE gpkg_contents SET min_x = ?, min_y = ?, max_x = ?, max_y = ? WHERE table_name = ?");
  int parameter = 1;
  for (const double bound : {all.x0, all.y0, all.x1, all.y1}) extent.bind(parameter++, bound);
  extent.bind_text(parameter, layer);
  extent.run();
}

}  // namespace

bool can_write_rows(const FieldPlan& plan) {
  return std::all_of(plan.fields.begin(), plan.fields.end(), [](const Column& field) {
    return is_number(field.type) || field.type == ColumnType::text || field.type == ColumnType::date;
  });
}

void write_rows(const GeopackageRows& output) {
  SqliteFile file(output.what.path, SqliteFile::Access::write, output.what.name);
  file.execute("BEGIN");
  const std::int32_t srs_id = srs_of_layer(file, output.what.layer);
  std::vector<IndexedBox> boxes;
  {
    SqliteStatement insert(file, insert_text(output));
    std::vector<std::string> dates(output.fields.size());
    for_all_batches(output, srs_id, 0, rows_end, [&](const Batch& batch) {
      auto id = static_cast<std::int64_t>(batch.first);
      for (const Row& row : batch.rows) {
        insert.bind(1, ++id);
        row.blob.empty() ? insert.bind_null(2) : insert.bind_blob(2, row.blob.data(), row.blob.size());
        for (std::size_t f = 0; f < dates.size(); ++f)
          bind_field(insert, static_cast<int>(f) + 3, *row.fields, static_cast<int>(f), dates[f]);
        insert.run();
        if (!row.blob.empty()) boxes.push_back({id, row.box});
      }
    });
  }
  set_counts(file, output, boxes);
  fill_index(file, fmt::format("rtree_{}_{}", output.what.layer, output.geometry_column), boxes);
  file.execute("COMMIT");
  file.close();
}

std::vector<std::uint64_t> check_rows(const GeopackageRows& output) {
  SqliteFile file(output.what.path, SqliteFile::Access::read, output.what.name);
  std::vector<std::uint64_t> lost(output.fields.size());
  SqliteStatement read(file, fmt::format("SELECT {} FROM {} ORDER BY 1", fmt::join(column_names(output), ", "),
                                         sql_name(output.what.layer)));
  const auto differs = [&] {
    throw IoError("cannot write " + output.what.name +
                  ": what was written does not read back whole (is the disk full?)");
  };
  for_all_batches(output, srs_of_layer(file, output.what.layer), index_end, 1, [&](const Batch& batch) {
    auto id = static_cast<std::int64_t>(batch.first);
    for (const Row& row : batch.rows) {
      if (!read.step() || sqlite3_column_int64(read.get(), 0) != ++id) differs();
      const auto bytes = static_cast<std::size_t>(sqlite3_column_bytes(read.get(), 1));
      if (bytes != row.blob.size() ||
          (bytes > 0 && std::memcmp(sqlite3_column_blob(read.get(), 1), row.blob.data(), bytes) != 0))
        differs();
      for (std::size_t f = 0; f < lost.size(); ++f) {
        const Found found = compare(read.get(), static_cast<int>(f) + 2, *row.fields, static_cast<int>(f));
        if (found == Found::other) differs();
        lost[f] += found == Found::lost;
      }
    }
  });
  if (read.step()) differs();
  return lost;
}

}  // namespace oblast::io
