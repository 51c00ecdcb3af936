// The reader of GeoJSON for all cores beside GDAL's driver, which is the judge: the same layers and rows, bit for bit.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/geojson_reader.h"
#include "io/geojson_text.h"
#include "io/rows.h"
#include "io_support.h"

namespace oblast::io {

namespace {

namespace fs = std::filesystem;

// What read_geojson() makes of a file: nothing if it leaves the file to GDAL.
std::optional<Layer> fast(const std::string& path, FileTable& table, Attributes attributes = Attributes::keep) {
  ReadOptions options;
  if (attributes == Attributes::keep) options.entries = FeatureEntries::all;
  return read_geojson(TextSource(path), {{path, {}}, path}, options, attributes, table);
}

bool is_fast(const std::string& path) {
  FileTable table;
  return fast(path, table).has_value();
}

std::string text_of(const ReadReport& r) {
  return fmt::format("{} {} {} {} {} {} {} {} {} {} {} {}", r.features, r.null_geometries, r.empty_geometries, r.lines,
                     r.points, r.with_z, r.with_m, r.unclosed_contours, r.repeated_vertices, r.beyond_pole,
                     r.across_date_line, r.swapped);
}

void expect_same(const Layer& a, const Layer& b) {
  EXPECT_TRUE(same_bits(a.regions, b.regions));
  ASSERT_EQ(a.features.size(), b.features.size());
  for (std::size_t f = 0; f < a.features.size(); ++f) {
    EXPECT_EQ(a.features[f].feature, b.features[f].feature);
    EXPECT_EQ(a.features[f].first_polygon, b.features[f].first_polygon);
    EXPECT_EQ(a.features[f].file, b.features[f].file);
  }
  EXPECT_EQ(a.files, b.files);
  EXPECT_EQ(a.crs_wkt, b.crs_wkt);
  EXPECT_EQ(text_of(a.report), text_of(b.report));
  EXPECT_EQ(a.open_contours, b.open_contours);
  EXPECT_EQ(a.columns, b.columns);
  EXPECT_EQ(a.notes, b.notes);
}

void expect_same(const AttributeTable& a, const AttributeTable& b) {
  EXPECT_EQ(a.columns(), b.columns());
  ASSERT_EQ(a.row_count(), b.row_count());
  for (std::size_t column = 0; column < a.columns().size(); ++column) {
    for (std::size_t row = 0; row < a.row_count(); ++row) {
      ASSERT_EQ(a.is_null(row, column), b.is_null(row, column)) << row;
      if (a.is_null(row, column)) continue;
      ASSERT_EQ(a.text(row, column), b.text(row, column)) << row;  // numbers with all digits
      if (a.columns()[column].type == ColumnType::real) {
        ASSERT_EQ(std::signbit(a.real(row, column)), std::signbit(b.real(row, column))) << row;
      }
    }
  }
}

// Reads a file in all ways, with both readers. Returns true if the fast one did it.
bool compare(const std::string& path) {
  SCOPED_TRACE(path);
  ReadOptions options;
  for (const RingVertices vertices : {RingVertices::cleaned, RingVertices::all}) {
    options.vertices = vertices;
    std::string errors[2];
    Rows rows[2];
    Layer layers[2];
    for (const int way : {0, 1}) {
      options.fast_geojson = way == 0;
      try {
        std::vector<std::string> notes;
        layers[way] = read_file(path, options);
        rows[way] = read_rows({&path, 1}, options, notes);
      } catch (const IoError& error) {
        errors[way] = error.what();
      }
    }
    EXPECT_EQ(errors[0], errors[1]);
    expect_same(layers[0], layers[1]);
    expect_same(rows[0].layer, rows[1].layer);
    if (errors[0].empty()) expect_same(rows[0].table, rows[1].table);
  }
  return is_fast(path);
}

const std::string ring = "[[0,0],[2,0],[2.5,2],[0,0]]";
const std::string polygon = R"({"type":"Polygon","coordinates":[)" + ring + "]}";

std::string collection(const std::string& features, const std::string& members = "") {
  return R"({"type":"FeatureCollection",)" + members + R"("features":[)" + features + "]}";
}

std::string feature(const std::string& properties, const std::string& geometry = polygon,
                    const std::string& more = "") {
  return R"({"type":"Feature",)" + more + R"("properties":)" + properties + R"(,"geometry":)" + geometry + "}";
}

class Geojson : public FolderTest {
 protected:
  // One feature for each value of one property.
  std::string values(const std::vector<std::string>& values) const {
    std::string features;
    for (const std::string& value : values)
      features += (features.empty() ? "" : ",\n") + feature(R"({"a":)" + value + R"(,"z":1})");
    return file("values.geojson", collection(features));
  }
  std::string one(const std::string& text) const { return file("one.geojson", text); }
};

}  // namespace

TEST(GeojsonShared, EveryFileIsReadAsGdalReadsIt) {
  std::size_t files = 0, fast_files = 0;
  for (const char* folder : {"realworld", "geopandas"}) {
    const fs::path root = fs::path(OBLAST_SHARED) / folder;
    ASSERT_TRUE(fs::exists(root)) << root;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
      if (entry.path().extension() != ".geojson") continue;
      ++files;
      fast_files += compare(entry.path().string());
    }
  }
  EXPECT_GT(files, 60U);
  EXPECT_GT(fast_files, 30U) << "of " << files;  // the others have points, lines or nested properties
}

TEST_F(Geojson, TypesOfColumns) {
  const std::vector<std::vector<std::string>> columns = {
      {"1", "2"},
      {"1", "3000000000"},
      {"3000000000", "1"},
      {"1", "2.5", "null"},
      {"2.0", "3000000000", "1"},
      {"true", "false", "null"},
      {"true", "7"},
      {"7", "true"},
      {"null", "null"},
      {"null", "true"},
      {"null", "2.5"},
      {R"("x")", R"("")", "null", R"("a \"b\" \\ \n é \ud83d\ude00")"},
      {R"("2026-01-31")", R"("2025/12/24")"},
      {R"("2026-01-31")", R"("2026-01-31T12:30:00Z")"},
      {R"("2026-01-31T12:30:00+02:00")", R"("2026-01-31")", "null"},
      {R"("12:30:15")", R"("11:00")"},
      {R"("2026-01-31")", R"("no date")"},
      {R"("no date")", R"("2026-01-31")"},
      {R"("12:30")", R"("2026-01-31")"},
      {R"("-5")", R"("1/2")", R"("a:1")"},
      {"1e5", "1E-3", "-0.0", "0.1", "-0"},
      {"9223372036854775806", "-9223372036854775807"},
      {"123456789012345678", "0.30000000000000004", "2.2250738585072014e-308"},
  };
  for (const auto& column : columns) EXPECT_TRUE(compare(values(column))) << column[0];
}

// Where GDAL's rules are many, the file is its.
TEST_F(Geojson, GdalReadsWhatIsUnusual) {
  const std::vector<std::vector<std::string>> columns = {
      {"[1,2]"},         {R"({"b":1})"},   {R"("x")", "1"},          {"1", R"("x")"},
      {"true", "\"x\""}, {"1.5", "\"x\""}, {"18446744073709551615"}, {"100000000000000000000000"},
      {R"("a\u0000b")"},
  };
  for (const auto& column : columns) EXPECT_FALSE(compare(values(column))) << column[0];
  const std::string two = R"({"a":1,"b":2})";
  for (const std::string& text : {
           collection(feature(two) + "," + feature(R"({"b":2,"a":1})")),
           collection(feature(two) + "," + feature(R"({"a":1})")),
           collection(feature(R"({"a":1,"a":2})")),
           collection(feature("null")),
           collection(feature(two, R"({"type":"Point","coordinates":[1,2]})")),
           collection(feature(two, R"({"type":"LineString","coordinates":[[1,2],[3,4]]})")),
           collection(feature(two, R"({"type":"Polygon","coordinates":[]})")),
           collection(feature(two, R"({"type":"Polygon","coordinates":[[]]})")),
           collection(feature(two, R"({"type":"Polygon","coordinates":[[[0,0,1,2],[1,0,1,2],[1,1,1,2]]]})")),
           collection(feature(two, R"({"type":"GeometryCollection","geometries":[]})")),
           collection(feature(two, polygon, R"("extra":5,)")),
           collection(feature(two, polygon, R"("id":"seven",)")),
           collection(feature(two, polygon, R"("id":-7,)")),
           collection(feature(two, polygon, R"("id":7,)") + "," + feature(two)),
           collection(feature(two, polygon, R"("id":7,)") + "," + feature(two, polygon, R"("id":7,)")),
           collection(feature(R"({"id":7})", polygon, R"("id":8,)")),
           collection(feature(R"({"id":7})") + "," + feature(R"({"id":7})")),
           collection(feature(R"({"id":7})") + "," + feature(R"({"id":null})")),
           collection(""),
           feature(two),
           polygon,
           R"({"features":[)" + feature(two) + R"(],"type":"FeatureCollection"})",
           collection(feature(two)) + "garbage",
           collection(feature(two)).substr(0, 150),
           collection(feature(two, R"({"type":"Polygon","coordinates":[[[0,0],[1e300,0],[1,1]]]})")),
           collection(feature(two, R"({"type":"Polygon","coordinates":[[["0",0],[1,0],[1,1]]]})")),
       })
    EXPECT_FALSE(compare(one(text))) << text;
}

TEST_F(Geojson, WhatIsUsual) {
  const std::string two = R"({"a":1,"b":"x"})";
  const std::string multi = R"({"type":"MultiPolygon","coordinates":[[)" + ring + "],[" + ring + "," + ring + "]]}";
  for (const std::string& text : {
           collection(feature(two)),
           collection(feature("{}") + "," + feature("{}")),
           collection(feature(two, multi) + "," + feature(two, "null")),
           collection(feature(two, "null") + "," + feature(two, "null")),
           collection(feature(two, R"({"type":"MultiPolygon","coordinates":[]})")),
           collection(feature(two, R"({"coordinates":[[[0,0],[1,0],[1,1]]],"type":"Polygon"})")),
           collection(feature(two, R"({"type":"Polygon","coordinates":[[[0,0,5],[1,0],[1,1,2],[1,1,2],[0,0,5]]]})")),
           collection(feature(two, polygon, R"("id":7,)") + "," + feature(two, polygon, R"("id":3,)")),
           collection(feature(R"({"id":7})") + "," + feature(R"({"id":3000000000})") + "," + feature(R"({"id":0})")),
           collection(feature(R"({"id":"b"})") + "," + feature(R"({"id":"a"})")),
           collection(feature(two), R"("name":"fires","crs":{"type":"name","properties":{"name":"EPSG:3035"}},)"),
           collection(feature(two), R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:OGC:1.3:CRS84"}},)"),
           collection(feature(two), R"("crs":null,)"),
           collection(feature(two), R"("bbox":[0,0,3,3],"features":[],)").replace(0, 1, " {"),
           collection(feature(two, R"({"type":"Polygon","coordinates":[[[0,0],[190,0],[190,95],[0,0]]]})")),
       })
    EXPECT_EQ(compare(one(text)), text.find("\"features\":[],") == std::string::npos) << text;
}

// Blocks of a few features, so that there are many cuts, some of them in strings that look like features.
TEST_F(Geojson, CutsAreRightOrTheFileIsGdals) {
  std::string plain, traps;
  for (int i = 0; i < 200; ++i) {
    plain += (i ? ",\n  " : "") + feature(fmt::format(R"({{"a":{},"b":"x"}})", i));
    traps += (i ? ",\n" : "") + feature(fmt::format(R"({{"a":{},"b":",{{\"type\":\"Feature\",\"pro"}})", i));
  }
  const std::string path = one(collection(plain));
  const TextSource text(path);
  for (const std::uint64_t size : {1, 10, 300, 5000, 1000000}) {
    const auto cut = cut_geojson(text, size);
    ASSERT_TRUE(cut);
    std::string joined = cut->head;
    for (const auto& [begin, end] : cut->blocks) joined += text.read(begin, end - begin) + ",\n  ";
    EXPECT_EQ(joined.substr(0, joined.size() - 4) + "]}", collection(plain));
    EXPECT_GE(cut->blocks.size(), size < 300 ? 200U : 1U);
  }
  EXPECT_TRUE(compare(path));
  EXPECT_TRUE(compare(one(collection(traps))));
}

TEST_F(Geojson, ManyBlocksKeepTheOrderOfTheFile) {
  std::string features;
  for (int i = 0; i < 20000; ++i) {
    const double x = i % 100, y = i / 100 * 0.3;
    features += fmt::format(
        R"({}{{ "type": "Feature", "properties": {{ "n": {}, "t": "text {}", "v": {} }}, "geometry": {{ "type": "Polygon", "coordinates": [ [ [ {}, {} ], [ {}, {} ], [ {}, {} ], [ {}, {} ] ] ] }} }})",
        i ? ",\n" : "", i * 200000LL, i, i % 1000 == 999 ? "0.5" : "2", x, y, x + 0.7, y, x + 0.3, y + 0.2, x, y);
  }
  const std::string path = one(collection(features));
  ASSERT_GT(fs::file_size(path), 3U << 20);  // several blocks
  EXPECT_TRUE(compare(path));
  for (const int threads : {1, 3}) {
    ReadOptions options;
    options.threads = threads;
    options.target_crs = crs_wkt(folder_.string(), 3035);
    std::vector<double> shares;
    options.progress = [&](double share) { shares.push_back(share); };
    const Layer a = read_file(path, options);
    EXPECT_GT(shares.size(), 3U);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    options.fast_geojson = false;
    expect_same(a, read_file(path, options));
  }
}

// An error is GDAL's or the builder's, with the number that the feature has in the file.
TEST_F(Geojson, ErrorsSayWhere) {
  std::string features;
  for (int i = 0; i < 20000; ++i) {
    const char* x = i == 15000 ? "1e300" : "2";
    features += fmt::format(R"({}{{"type":"Feature","properties":{{"n":"{:0100}"}},"geometry":{{"type":"Polygon",)"
                            R"("coordinates":[[[0,0],[{},0],[1,1],[0,0]]]}}}})",
                            i ? "," : "", i, x);
  }
  EXPECT_TRUE(mentions(read_error(one(collection(features))),
                       {"one.geojson, feature 15000, part 1, ring 1, vertex 1", "outside the domain"}));
  EXPECT_NE(read_error(one(collection(features).substr(0, 3000000))), "");
}

}  // namespace oblast::io
