// Folders, archives and layers; see source.h.
#include "io/source.h"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>

#include "io/formats.h"
#include "io/gdal_session.h"
#include "io/layer.h"
#include "io/paths.h"

namespace oblast::io {

namespace fs = std::filesystem;

namespace {

using Names = std::vector<std::string>;

// True if the head of a table of text names a column WKT.
bool has_wkt_column(const std::string& path) {
  const auto close = [](VSILFILE* file) { VSIFCloseL(file); };
  const std::unique_ptr<VSILFILE, decltype(close)> file(VSIFOpenL(path.c_str(), "rb"), close);
  const char* line = file ? CPLReadLine2L(file.get(), 1 << 16, nullptr) : nullptr;
  if (!line) return false;
  const CPLStringList fields(CSLTokenizeString2(line, ",;\t", CSLT_HONOURSTRINGS));
  return fields.FindString("WKT") >= 0;
}

bool is_vector_file(const std::string& path) {
  const Format* format = format_of(path);
  if (!format) return false;
  if (is_csv(path)) return has_wkt_column(path);
  if (!format->may_be_other) return true;
  register_gdal_drivers();
  GdalMessages messages;
  return GDALIdentifyDriverEx(path.c_str(), GDAL_OF_VECTOR, format->drivers, nullptr) != nullptr;
}

// A file that belongs to another one, and is read with it or not needed.
bool is_companion(const fs::path& file) {
  const std::string name = file.filename().string();
  for (const char* end : {"-wal", "-shm", "-journal", ".shp.xml", ".gpkg.aux.xml"}) {
    if (name.ends_with(end)) return true;
  }
  static const std::set<std::string> extensions = {".dbf", ".shx", ".prj", ".cpg", ".qix", ".sbn", ".sbx",  ".qpj",
                                                   ".qmd", ".qml", ".sld", ".idx", ".map", ".id",  ".csvt", ".xsd",
                                                   ".gfs", ".dat", ".mid", ".ind", ".fbn", ".fbx"};
  return extensions.contains(lower_extension(name));
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

bool same_file(const fs::path& file, const std::string& other) {
  std::error_code error;
  return !other.empty() && fs::equivalent(file, other, error);
}

// What a folder has, sorted by name.
struct Contents {
  std::vector<fs::path> files;
  Names folders;
};

Contents contents_of(const std::string& folder) {
  Contents found;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (name.front() == '.') continue;
    if (it->is_directory(error) && lower_extension(name) != ".gdb") {
      found.folders.push_back(name);
    } else {
      found.files.push_back(it->path());
    }
  }
  if (error) throw CannotOpen("cannot read the folder " + folder + ": " + error.message());
  std::sort(found.files.begin(), found.files.end());
  std::sort(found.folders.begin(), found.folders.end());
  return found;
}

void say(SourceList& list, const std::string& folder, const Names& names, const char* one, const char* several) {
  if (names.empty()) return;
  list.notes.push_back(
      names.size() == 1 ? fmt::format("{}: {} was not read: {}", folder, one, names.front())
                        : fmt::format("{}: {} {} were not read: {}", folder, names.size(), several, name_list(names)));
}

void add_folder(const std::string& folder, const SourceOptions& options, SourceList& list) {
  const Contents contents = contents_of(folder);
  refuse_headless_shapefiles(contents.files);
  Names others;
  std::size_t found = 0;
  for (const fs::path& file : contents.files) {
    if (same_file(file, options.output)) {
      list.notes.push_back(file.string() + " is the output of this call, and was not read");
    } else if (is_vector_file(file.string())) {
      list.sources.push_back({file.string(), options.layer});
      ++found;
    } else if (!is_companion(file)) {
      others.push_back(file.filename().string());
    }
  }
  if (found == 0)
    throw IoError(fmt::format("no vector files in the folder {} (readable: {}){}", folder, readable_extensions(),
                              contents.folders.empty() ? "" : "; its subfolders are not read: name one of them"));
  say(list, folder, others, "a file that is no vector file", "files that are no vector files");
  say(list, folder, contents.folders, "a subfolder", "subfolders");
}

// The vector files of a folder of an archive, with those of its subfolders.
Names files_in_archive(const std::string& folder) {
  Names found;
  const CPLStringList names(VSIReadDirRecursive(folder.c_str()));
  for (int i = 0; i < names.Count(); ++i) {
    const std::string name = names[i];
    const std::string path = fmt::format("{}/{}", folder, name);
    if (fs::path(name).filename().string().front() != '.' && !name.starts_with("__MACOSX") && !is_folder(path) &&
        is_vector_file(path))
      found.push_back(name);
  }
  std::sort(found.begin(), found.end());
  return found;
}

// `wanted` is a file of the archive, with or without its folder or its extension, or the layer of its only file.
Source source_in_archive(const std::string& folder, const std::string& shown, const std::string& wanted) {
  const Names files = files_in_archive(folder);
  if (files.empty())
    throw IoError(fmt::format("no vector files in the archive {} (readable: {})", shown, readable_extensions()));
  if (!wanted.empty()) {
    for (const std::string& file : files) {
      const fs::path path = file;
      if (wanted == file || wanted == path.filename().string() || wanted == path.stem().string())
        return {fmt::format("{}/{}", folder, file), {}};
    }
  }
  if (files.size() == 1) return {folder + "/" + files.front(), wanted};
  throw IoError(fmt::format("{} has {} vector files: {}; name one of them, as in {}:{}", shown, files.size(),
                            name_list(files), shown, files.front()));
}

bool is_archive(const std::string& path) { return lower_extension(path) == ".zip"; }

// FILE:LAYER, if there is a file of that name. A colon may be part of either name.
std::optional<Source> split(const std::string& path) {
  if (path == "-" || path_exists(path)) return Source{path, {}};
  for (std::size_t colon = path.find(':'); colon != std::string::npos; colon = path.find(':', colon + 1)) {
    const std::string file = path.substr(0, colon);
    if (colon > 0 && path_exists(file) && (!is_folder(file) || lower_extension(file) == ".gdb" || is_archive(file)))
      return Source{file, path.substr(colon + 1)};
  }
  if (path.starts_with("/vsi")) return Source{path, {}};  // GDAL says what is wrong with it
  return std::nullopt;
}

CannotOpen cannot_open(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (error && status.type() != fs::file_type::not_found)
    return CannotOpen("cannot read " + path + ": " + error.message());
  return CannotOpen("no such file or folder: " + path);
}

void refuse_unreadable(const std::string& path) {
  if (path == "-" || path.starts_with("/vsi") || ::access(path.c_str(), R_OK) == 0) return;
  throw CannotOpen("cannot read " + path + ": " + std::strerror(errno));
}

}  // namespace

std::string Source::name() const {
  const std::string file = path == "-" ? "standard input" : path;
  return layer.empty() ? file : file + ":" + layer;
}

SourceList list_sources(std::span<const std::string> paths, const SourceOptions& options) {
  SourceList list;
  int from_standard_input = 0;
  for (const std::string& path : paths) {
    std::optional<Source> source = split(path);
    if (!source) throw cannot_open(path);
    refuse_unreadable(source->path);
    from_standard_input += path == "-";
    const std::string layer = source->layer.empty() && path != "-" ? options.layer : source->layer;
    if (is_archive(source->path)) {
      const bool is_virtual = source->path.starts_with("/vsi");
      list.sources.push_back(source_in_archive((is_virtual ? "" : "/vsizip/") + source->path, source->path, layer));
    } else if (!is_folder(source->path) || lower_extension(source->path) == ".gdb") {
      list.sources.push_back({source->path, layer});
    } else if (source->path.starts_with("/vsi")) {
      list.sources.push_back(source_in_archive(source->path, source->path, layer));
    } else {
      add_folder(source->path, options, list);
    }
  }
  if (list.sources.empty()) throw IoError("no input: name a file, a folder, or `-` for standard input");
  if (from_standard_input > 1) throw IoError("standard input (-) can be named only once");
  return list;
}

}  // namespace oblast::io
