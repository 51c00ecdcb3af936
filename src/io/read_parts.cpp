// Reads any number of files in parallel; see read_parts.h.
#include "io/read_parts.h"

#include <ogr_feature.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <mutex>

#include "io/crs.h"
#include "io/formats.h"
#include "io/gdal_reader.h"
#include "io/geojson_reader.h"
#include "io/paths.h"
#include "io/standard_input.h"
#include "io/wkb_reader.h"

namespace oblast::io {

FileTable::FileTable() = default;
FileTable::~FileTable() = default;
FileTable::FileTable(FileTable&&) noexcept = default;
FileTable& FileTable::operator=(FileTable&&) noexcept = default;

namespace {

void refuse_what_text_has_not(const Source& source, const char* format, const ReadOptions& options) {
  if (!options.where.empty())
    throw IoError(source.name() + " is " + format + ", which has no attributes for a condition");
  if (!source.layer.empty()) throw IoError(source.path + " is " + format + ", which has no layers; leave out the name");
}

// The file itself, or the text that came from standard input under a name of its own.
void read_json_or_other(const TextSource* text, const NamedSource& named, const ReadOptions& options,
                        Attributes attributes, FilePart& part) {
  if (text && options.fast_geojson) {
    if (std::optional<Layer> layer = read_geojson(*text, named, options, attributes, part.table)) {
      part.layer = std::move(*layer);
      return;
    }
  }
  part.layer = read_with_gdal(named, options, attributes, part.table);
}

using Progress = std::function<void(double share)>;

FilePart read_one(const Source& source, const ReadOptions& options, Attributes attributes, const Progress& progress) {
  FilePart part;
  const bool piped = source.path == "-";
  if (!piped && !is_wkt(source.path) && !is_wkb(source.path)) {
    std::optional<TextSource> file;
    std::error_code error;  // a pipe can be opened only once
    if (is_geojson(source.path) && std::filesystem::is_regular_file(source.path, error)) file.emplace(source.path);
    read_json_or_other(file ? &*file : nullptr, {source, source.name(), progress}, options, attributes, part);
    return part;
  }
  std::string text = read_text(source.path);
  const ContentKind kind = piped ? kind_of_content(text) : is_wkb(source.path) ? ContentKind::wkb : ContentKind::wkt;
  if (kind == ContentKind::json) {
    const MemoryFile file(std::move(text), "standard_input.json");
    const TextSource bytes(file.text(), source.name());
    read_json_or_other(&bytes, {{file.path(), {}}, source.name(), progress}, options, attributes, part);
    return part;
  }
  refuse_what_text_has_not(source, kind == ContentKind::wkb ? "WKB" : "WKT", options);
  part.layer =
      kind == ContentKind::wkb ? read_wkb(text, source.name(), options) : read_wkt(text, source.name(), options);
  return part;
}

// What has been read of several files, by bytes.
class ReadShare {
 public:
  ReadShare(const std::vector<Source>& sources, const Progress& progress) : progress_(progress) {
    for (const Source& source : sources) {
      const std::uint64_t size = source.path == "-" ? 0 : size_of_file(source.path);
      files_.push_back({static_cast<double>(size) + 1, 0});  // a file without a known size counts, too
      whole_ += files_.back().weight;
    }
  }

  void file(std::size_t i, double share) {
    if (!progress_) return;
    const std::lock_guard lock(mutex_);
    if (share <= files_[i].share) return;
    done_ += files_[i].weight * (share - files_[i].share);
    files_[i].share = share;
    progress_(std::min(1.0, done_ / whole_));
  }

 private:
  struct File {
    double weight, share;
  };
  const Progress& progress_;
  std::vector<File> files_;
  double whole_ = 0, done_ = 0;
  std::mutex mutex_;
};

}  // namespace

Parts read_parts(std::span<const std::string> paths, const ReadOptions& options, Attributes attributes) {
  SourceList list = list_sources(paths, {options.layer, options.output});
  const std::vector<Source>& sources = list.sources;
  Parts parts;
  parts.notes = std::move(list.notes);
  parts.files.resize(sources.size());
  std::vector<std::exception_ptr> failures(sources.size());
  std::atomic<std::size_t> first_failure = sources.size();
  ReadShare share(sources, options.progress);

  const auto read_file = [&](std::size_t i) {
    if (i > first_failure) return;
    try {
      parts.files[i] = read_one(sources[i], options, attributes, [&, i](double done) { share.file(i, done); });
      share.file(i, 1);
    } catch (...) {
      failures[i] = std::current_exception();
      std::size_t first = first_failure;
      while (i < first && !first_failure.compare_exchange_weak(first, i)) {
      }
    }
  };
  // More threads than cores would gain nothing, and TBB would say so on standard error.
  const int cores = tbb::info::default_concurrency();
  tbb::task_arena arena(options.threads > 0 ? std::min(options.threads, cores) : cores);
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, sources.size(), read_file); });
  if (first_failure < sources.size()) std::rethrow_exception(failures[first_failure]);

  CommonCrs crs;
  for (const FilePart& part : parts.files) crs.add(part.layer.crs_wkt, part.layer.files.front());
  parts.crs_wkt = crs.wkt();
  return parts;
}

}  // namespace oblast::io
