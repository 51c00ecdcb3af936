// Checks the call, writes to the stage, and renames.
#include "io/write.h"

#include <fmt/format.h>
#include <oblast/wkb.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "io/crs.h"
#include "io/formats.h"
#include "io/gdal_writer.h"
#include "io/geojson_writer.h"
#include "io/paths.h"
#include "io/row_writers.h"
#include "io/staged_output.h"
#include "io/write_rows.h"
#include "io/write_text.h"

namespace oblast::io {

namespace fs = std::filesystem;

namespace {

const Format& writable_format(const std::string& path) {
  const Format* format = format_of(path);
  if (format && format->writable) return *format;
  const std::string extension = lower_extension(path);
  throw IoError("cannot write " + path + ": " +
                (extension.empty() ? "its name has no extension, which decides the format"
                                   : extension + " is not a format that can be written") +
                "; choose from " + writable_extensions());
}

OutputFiles files_of(const std::string& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".shp") {
    return {{".dbf", ".cpg", ".prj", ".shx", ""}, {}, {".qix", ".sbn", ".sbx", ".qpj"}};
  }
  // A journal of an older database would be applied to the new one.
  if (extension == ".gpkg") return {{""}, {"-journal", "-wal", "-shm"}, {"-journal", "-wal", "-shm"}};
  if (extension == ".fgb") return {{""}, {"_temp.fgb"}, {}};
  if (extension == ".csv") return {{".csvt", ""}, {}, {}};
  if (extension == ".gml") return {{".xsd", ""}, {".gfs"}, {".gfs"}};
  return {};
}

void refuse_existing(const std::string& path) {
  std::vector<std::string> parts = files_of(path).parts;
  std::reverse(parts.begin(), parts.end());  // the target itself first
  for (const std::string& part : parts) {
    const std::string file = part.empty() ? path : fs::path(path).replace_extension(part).string();
    std::error_code error;
    if (fs::exists(fs::symlink_status(file, error))) {
      throw IoError(file + " exists already (--overwrite replaces it)");
    }
  }
}

// A GeoPackage is changed, not replaced, if it has more than the layer that is written.
bool is_changed(const OutputTarget& target, const ExistingGeopackage& existing) {
  return existing.readable && (!existing.others.empty() || (!target.layer.empty() && !existing.has_layer));
}

void check_geopackage(const OutputTarget& target, const WriteOptions& options) {
  std::error_code error;
  if (!fs::exists(target.path, error)) return;
  const ExistingGeopackage existing = existing_geopackage(target);
  if (target.layer.empty()) {
    if (options.existing == Existing::refuse) refuse_existing(target.path);
    return;
  }
  if (!existing.readable) throw IoError(target.path + " is no GeoPackage that can be read, so no layer can be added");
  if (existing.has_layer && options.existing == Existing::refuse)
    throw IoError(fmt::format("{} has a layer {} already (--overwrite replaces it)", target.path, target.layer));
}

// To see whether another program changed a file in the meantime.
std::pair<std::uintmax_t, fs::file_time_type> state_of(const std::string& path) {
  std::error_code error;
  return {fs::file_size(path, error), fs::last_write_time(path, error)};
}

}  // namespace

TextFormat text_format_of(const std::string& path) {
  if (is_geojson(path)) return TextFormat::geojson;
  return is_wkb(path) ? TextFormat::wkb : TextFormat::wkt;
}

void write_staged(const OutputTarget& target, const WriteOptions& options,
                  const std::function<void(const std::string& path)>& write_to) {
  StagedOutput stage(target.path, files_of(target.path));
  const ExistingGeopackage existing = existing_geopackage(target);
  const bool changed = is_changed(target, existing);
  const auto state = state_of(target.path);
  if (changed) copy_geopackage(target, stage.path());
  write_to(stage.path());
  if (changed) {
    if (state != state_of(target.path))
      throw IoError(target.path + " was changed by another program in the meantime; run the command again");
    if (options.notes && target.layer.empty())
      options.notes->push_back(fmt::format("{} keeps what it had besides the layer {}: {}", target.path,
                                           target.layer_name(), name_list(existing.others)));
  } else if (options.existing == Existing::refuse) {
    refuse_existing(target.path);  // another program may have made a file of this name in the meantime
  }
  stage.commit();
}

void check_crs_of_format(const std::string& path, const std::string& crs_wkt) {
  if (is_geojson(path)) geojson_crs_code(crs_wkt);
  if (lower_extension(path) == ".kml" && !same_crs(crs_wkt, crs_from_text("EPSG:4326")))
    throw IoError(
        fmt::format("cannot write {}: KML is always in WGS 84 (EPSG:4326), but the result is in {}; add "
                    "--t_srs EPSG:4326, or write .gpkg",
                    path, crs_name(crs_wkt)));
}

void check_writable(const std::string& path_given, const WriteOptions& options) {
  if (path_given == "-") return;
  const OutputTarget target = output_target(path_given);
  const std::string& path = target.path;
  require_writer(writable_format(path), path);
  const fs::path parent = fs::path(path).has_parent_path() ? fs::path(path).parent_path() : fs::path(".");
  std::error_code error;
  if (!fs::exists(parent, error))
    throw IoError("cannot write " + path + ": there is no folder " + parent.string() + "; create it first");
  if (!fs::is_directory(parent, error))
    throw IoError("cannot write " + path + ": " + parent.string() + " is not a folder");
  if (fs::is_directory(path, error)) throw IoError("cannot write " + path + ": it is a folder");
  if (target.is_geopackage()) {
    check_geopackage(target, options);
  } else if (options.existing == Existing::refuse) {
    refuse_existing(path);
  }
  if (::access(parent.c_str(), W_OK | X_OK) != 0) {
    throw IoError("cannot write into " + parent.string() + ": " + std::strerror(errno));
  }
  check_crs_of_format(path, options.crs_wkt);
}

namespace {

std::string to_text(const RegionView& regions, TextFormat format, const WriteOptions& options) {
  if (format == TextFormat::geojson)
    return to_geojson(regions, geojson_crs_code(options.crs_wkt), options.polygon_numbers);
  if (format == TextFormat::wkt) return to_wkt(regions) + "\n";
  const std::vector<std::byte> bytes = to_wkb(regions);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// Each polygon as a row with its number.
struct PolygonRows {
  std::vector<std::uint32_t> ends;
  OutputColumn number{.column = {"polygon", ColumnType::integer}};

  PolygonRows(const RegionView& regions, const WriteOptions& options) {
    const std::size_t polygons = regions.polygon_count();
    for (std::size_t p = 0; p < polygons; ++p) {
      ends.push_back(static_cast<std::uint32_t>(p + 1));
      number.values.emplace_back(options.polygon_numbers.empty() ? static_cast<std::int64_t>(p)
                                                                 : std::int64_t{options.polygon_numbers[p]});
    }
  }
};

void write_with_driver(const GdalLayer& what, const RegionView& regions, const WriteOptions& options) {
  if (what.driver != "GPKG") return write_with_gdal(what, regions, options.polygon_numbers, options.notes);
  const PolygonRows rows(regions, options);
  const FeatureView view{regions, rows.ends};
  std::vector<std::string> notes;
  write_rows_with_gdal(what, {view, std::span(&rows.number, 1), what.crs_wkt, what.name, options.progress},
                       GeopackageShape::polygon, options.notes ? *options.notes : notes);
}

}  // namespace

void write(const std::string& path_given, const RegionView& regions, const WriteOptions& options) {
  check_writable(path_given, options);
  if (path_given == "-") return write_text_to_standard_output(to_text(regions, options.standard_output, options));
  if (is_csv(path_given)) {  // a table
    const PolygonRows rows(regions, options);
    std::vector<std::string> notes;
    return write_rows(path_given, {regions, rows.ends}, std::span(&rows.number, 1), options,
                      options.notes ? *options.notes : notes);
  }
  const OutputTarget target = output_target(path_given);
  write_staged(target, options, [&](const std::string& stage) {
    if (const char* driver = writable_format(target.path).writer) {
      write_with_driver({stage, driver, target.layer_name(), options.crs_wkt, target.path}, regions, options);
    } else {
      write_text(stage, to_text(regions, text_format_of(target.path), options), target.path);
    }
  });
}

}  // namespace oblast::io
