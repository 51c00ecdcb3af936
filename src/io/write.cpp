// Checks the call, writes to the stage, and renames.
#include "io/write.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "io/formats.h"
#include "io/gdal_writer.h"
#include "io/geojson_writer.h"
#include "io/staged_output.h"
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

}  // namespace

// A shapefile's .shp names the whole set.
std::string target_of(const std::string& path) {
  return lower_extension(path) == ".shp" ? fs::path(path).replace_extension(".shp").string() : path;
}

void write_staged(const std::string& target, Existing existing,
                  const std::function<void(const std::string& path)>& write_to) {
  StagedOutput stage(target, files_of(target));
  write_to(stage.path());
  // Another program may have made a file of this name in the meantime.
  if (existing == Existing::refuse) refuse_existing(target);
  stage.commit();
}

void check_writable(const std::string& path_given, const WriteOptions& options) {
  if (path_given == "-") return;
  writable_format(path_given);
  const std::string path = target_of(path_given);
  const fs::path parent = fs::path(path).has_parent_path() ? fs::path(path).parent_path() : fs::path(".");
  std::error_code error;
  if (!fs::exists(parent, error))
    throw IoError("cannot write " + path + ": there is no folder " + parent.string() + "; create it first");
  if (!fs::is_directory(parent, error))
    throw IoError("cannot write " + path + ": " + parent.string() + " is not a folder");
  if (fs::is_directory(path, error)) throw IoError("cannot write " + path + ": it is a folder");
  if (options.existing == Existing::refuse) refuse_existing(path);
  if (::access(parent.c_str(), W_OK | X_OK) != 0) {
    throw IoError("cannot write into " + parent.string() + ": " + std::strerror(errno));
  }
  if (is_geojson(path)) geojson_crs_code(options.crs_wkt);
}

void write(const std::string& path_given, const RegionView& regions, const WriteOptions& options) {
  check_writable(path_given, options);
  if (path_given == "-") {
    write_text_to_standard_output(to_wkt(regions) + "\n");
    return;
  }
  const std::string path = target_of(path_given);
  write_staged(path, options.existing, [&](const std::string& stage) {
    if (const char* driver = writable_format(path).writer) {
      write_with_gdal(stage, driver, regions, options.crs_wkt, path, options.polygon_numbers);
    } else if (is_geojson(path)) {
      write_text(stage, to_geojson(regions, geojson_crs_code(options.crs_wkt), options.polygon_numbers), path);
    } else {
      write_text(stage, to_wkt(regions) + "\n", path);
    }
  });
}

}  // namespace oblast::io
