// GeoPackages that SQLite fills: their spatial index, their counts, their values.
#include <fmt/format.h>
#include <oblast/measure.h>

#include <cmath>
#include <random>

#include "io/rows.h"
#include "io/sqlite_file.h"
#include "io/write_rows.h"
#include "io_support.h"

namespace oblast::io {

namespace {

class Geopackage : public FolderTest {
 protected:
  std::string text(const std::string& sql, SqliteFile::Access access = SqliteFile::Access::read) const {
    SqliteFile file(path("a.gpkg"), access, "a.gpkg");
    SqliteStatement statement(file, sql);
    std::string all;
    while (statement.step()) {
      for (int c = 0; c < sqlite3_column_count(statement.get()); ++c) {
        const auto* value = reinterpret_cast<const char*>(sqlite3_column_text(statement.get(), c));
        all += (all.empty() ? "" : " ") + std::string(value ? value : "null");
      }
    }
    return all;
  }

  // Rows of a file as they are, in a GeoPackage.
  std::vector<std::string> copy(const Rows& rows) const {
    std::vector<std::uint32_t> all(rows.table.row_count());
    for (std::uint32_t row = 0; row < all.size(); ++row) all[row] = row;
    std::vector<OutputColumn> columns;
    for (std::size_t c = 0; c < rows.table.columns().size(); ++c)
      columns.push_back({rows.table.columns()[c], &rows.table, c, all, {}});
    std::vector<std::string> notes;
    WriteOptions options;
    options.crs_wkt = rows.layer.crs_wkt;
    write_rows(path("a.gpkg"), rows.view(), columns, options, notes);
    return notes;
  }

  static Rows rows_of(const std::string& path) {
    std::vector<std::string> notes;
    return read_rows({&path, 1}, {}, notes);
  }
};

std::string text_of(const AttributeTable& table) {
  std::string all;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    for (std::size_t c = 0; c < table.columns().size(); ++c)
      all += (table.is_null(row, c) ? "null" : table.text(row, c)) + "|";
    all += "\n";
  }
  return all;
}

}  // namespace

// A node has 51 cells, so these numbers have trees of one, two and three levels, with full nodes and with one more
// cell.
TEST_F(Geopackage, IndexIsWholeAtEverySize) {
  for (const std::size_t count : {0, 1, 51, 52, 102, 2601, 2602, 9000}) {
    SCOPED_TRACE(count);
    const RegionSet regions = scattered(count, 7);
    WriteOptions options;
    options.existing = Existing::overwrite;
    write(path("a.gpkg"), regions, options);
    EXPECT_TRUE(same_bits(read_file(path("a.gpkg")).regions, regions));
    EXPECT_EQ(text("PRAGMA integrity_check"), "ok");
    EXPECT_EQ(text("SELECT rtreecheck('rtree_a_geom')"), "ok");
    EXPECT_EQ(text("SELECT count(*) FROM rtree_a_geom"), std::to_string(count));
    EXPECT_EQ(text("SELECT feature_count FROM gpkg_ogr_contents"), std::to_string(count));
    const std::vector<std::uint32_t>& ends = regions.polygon_ends;
    std::mt19937 random(3);
    for (int repeat = 0; repeat < 20; ++repeat) {
      const double x = std::uniform_real_distribution(-180.0, 180.0)(random);
      const double y = std::uniform_real_distribution(-90.0, 90.0)(random);
      const double width = std::uniform_real_distribution(0.0, 20.0)(random);
      std::string expected;
      for (std::size_t p = 0; p < ends.size(); ++p) {
        const RegionView view = regions;
        Box box{1e9, 1e9, -1e9, -1e9};
        for (const Point& point : view.contour(view.polygon_begin(p)))
          box = {std::min(box.x0, point.x), std::min(box.y0, point.y), std::max(box.x1, point.x),
                 std::max(box.y1, point.y)};
        if (box.x0 <= x + width && box.x1 >= x && box.y0 <= y + width && box.y1 >= y)
          expected += (expected.empty() ? "" : " ") + std::to_string(p + 1);
      }
      // Boxes of the index are floats, a little larger; here none is so near the window.
      EXPECT_EQ(text(fmt::format("SELECT id FROM rtree_a_geom WHERE minx <= {} AND maxx >= {} AND miny <= {} AND maxy "
                                 ">= {} ORDER BY id",
                                 x + width, x, y + width, y)),
                expected);
    }
  }
}

TEST_F(Geopackage, IndexCanBeChangedLater) {
  write(path("a.gpkg"), scattered(3000, 7));
  text("DELETE FROM rtree_a_geom WHERE id % 3 != 0", SqliteFile::Access::write);
  EXPECT_EQ(text("SELECT rtreecheck('rtree_a_geom')"), "ok");
  text("INSERT INTO rtree_a_geom VALUES (7, 1, 2, 3, 4)", SqliteFile::Access::write);
  EXPECT_EQ(text("SELECT rtreecheck('rtree_a_geom')"), "ok");
  EXPECT_EQ(text("SELECT count(*) FROM rtree_a_geom"), "1001");
}

TEST_F(Geopackage, ValuesComeBack) {
  const std::string polygon = R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]]]})";
  std::string features;
  const auto add = [&](const std::string& properties, const std::string& geometry) {
    features += (features.empty() ? "" : ",") + std::string(R"({"type":"Feature","properties":)") + properties +
                R"(,"geometry":)" + geometry + "}";
  };
  add(R"({"i":1,"l":3000000000,"r":0.1,"t":"it's \"é\"","b":true,"d":"2026-02-28","fid":5,"geom":"x"})", polygon);
  add(R"({"i":-7,"l":-1,"r":1e-300,"t":"","b":false,"d":"0812-01-01","fid":5,"geom":""})", "null");
  add(R"({"i":null,"l":null,"r":null,"t":null,"b":null,"d":null,"fid":null,"geom":null})", polygon);
  const Rows given = rows_of(file("a.geojson", R"({"type":"FeatureCollection","features":[)" + features + "]}"));
  EXPECT_EQ(copy(given), std::vector<std::string>{});
  const Rows read = rows_of(path("a.gpkg"));
  EXPECT_EQ(text_of(read.table), text_of(given.table));
  EXPECT_TRUE(same_bits(read.layer.regions, given.layer.regions));
  EXPECT_EQ(read.ends, given.ends);
  EXPECT_EQ(text("SELECT min_x, min_y, max_x, max_y FROM gpkg_contents"), "0.0 0.0 1.0 1.0");
  EXPECT_EQ(text("SELECT seq FROM sqlite_sequence WHERE name = 'a'"), "3");  // the next row gets 4
  EXPECT_EQ(text("SELECT feature_count FROM gpkg_ogr_contents"), "3");
  EXPECT_EQ(text("SELECT id FROM rtree_a_geom_"), "1 3");
  const std::string bytes = contents("a.gpkg");
  std::filesystem::remove(path("a.gpkg"));
  copy(given);
  EXPECT_EQ(contents("a.gpkg"), bytes);
}

// Times have more forms than this writer knows; GDAL writes them.
TEST_F(Geopackage, MomentsAreWrittenByGdal) {
  const Rows given = rows_of(
      file("a.geojson",
           R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"m":"2026-02-28T12:00:00Z"},)"
           R"("geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]]]}}]})"));
  EXPECT_EQ(copy(given), std::vector<std::string>{});
  EXPECT_EQ(text("SELECT m FROM a"), "2026-02-28T12:00:00.000Z");
}

TEST_F(Geopackage, WhatSqliteDoesNotKnowIsSaid) {
  const RegionSet regions = scattered(2, 3);
  const std::vector<std::uint32_t> ends{1, 2};
  OutputColumn column;
  column.column.name = "v";
  column.column.type = ColumnType::real;
  column.values.emplace_back(std::nan(""));
  column.values.emplace_back(2.5);
  std::vector<std::string> notes;
  write_rows(path("a.gpkg"), {regions, ends}, {&column, 1}, {}, notes);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_TRUE(mentions(notes[0], {"v: 1 of the values read back different"}));
  EXPECT_EQ(text("SELECT v FROM a"), "null 2.5");
}

}  // namespace oblast::io
