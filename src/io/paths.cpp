// Files and folders; see paths.h.
#include "io/paths.h"

#include <gdal_priv.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <set>

#include "io/formats.h"
#include "io/gdal_session.h"
#include "io/layer.h"

namespace oblast::io {

namespace fs = std::filesystem;

namespace {

bool is_vector_file(const std::string& path) {
  const Format* format = format_of(path);
  if (!format) return false;
  if (!format->may_be_other) return true;
  register_gdal_drivers();
  GdalMessages messages;
  return GDALIdentifyDriverEx(path.c_str(), GDAL_OF_VECTOR, format->drivers, nullptr) != nullptr;
}

// Without this check, a shapefile without its .shp file would be skipped silently.
void refuse_headless_shapefiles(const std::vector<fs::path>& files) {
  std::set<std::string> shapes;
  for (const fs::path& file : files) {
    if (lower_extension(file.string()) == ".shp") shapes.insert(file.stem().string());
  }
  for (const fs::path& file : files) {
    if (lower_extension(file.string()) == ".shx" && !shapes.contains(file.stem().string())) {
      throw IoError(file.string() + " has no .shp file beside it: the shapefile is incomplete; add the .shp file");
    }
  }
}

std::vector<std::string> vector_files_in(const std::string& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (name.front() == '.' || it->is_directory(error)) continue;
    files.push_back(it->path());
  }
  if (error) throw CannotOpen("cannot read the folder " + folder + ": " + error.message());
  refuse_headless_shapefiles(files);

  std::vector<std::string> found;
  for (const fs::path& file : files) {
    if (is_vector_file(file.string())) found.push_back(file.string());
  }
  std::sort(found.begin(), found.end());
  if (found.empty())
    throw IoError("no vector files in the folder " + folder + " (readable: " + readable_extensions() + ")");
  return found;
}

}  // namespace

std::vector<std::string> expand_paths(std::span<const std::string> paths) {
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (path == "-" || path.starts_with("/vsi")) {
      files.push_back(path);
    } else if (status.type() == fs::file_type::not_found) {
      throw CannotOpen("no such file or folder: " + path);
    } else if (error || ::access(path.c_str(), R_OK) != 0) {
      throw CannotOpen("cannot read " + path + ": " + (error ? error.message() : std::strerror(errno)));
    } else if (fs::is_directory(status) && lower_extension(path) != ".gdb") {
      const auto found = vector_files_in(path);
      files.insert(files.end(), found.begin(), found.end());
    } else {
      files.push_back(path);
    }
  }
  if (files.empty()) throw IoError("no input: name a file, a folder, or `-` for standard input");
  if (std::count(files.begin(), files.end(), "-") > 1) throw IoError("standard input (-) can be named only once");
  return files;
}

std::string read_text(const std::string& path) {
  const auto close = [](std::FILE* f) {
    if (f != stdin) std::fclose(f);
  };
  std::unique_ptr<std::FILE, decltype(close)> file(path == "-" ? stdin : std::fopen(path.c_str(), "rb"), close);
  if (!file) throw CannotOpen("cannot read " + path + ": " + std::strerror(errno));
  std::string text;
  constexpr std::size_t chunk = 1 << 20;
  for (;;) {
    const std::size_t size = text.size();
    text.resize(size + chunk);
    const std::size_t got = std::fread(text.data() + size, 1, chunk, file.get());
    text.resize(size + got);
    if (got < chunk) break;
  }
  if (std::ferror(file.get())) throw IoError("cannot read " + path + ": " + std::strerror(errno));
  return text;
}

}  // namespace oblast::io
