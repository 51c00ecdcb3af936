// Blocks in parallel, joined in their order; see geojson_reader.h.
#include "io/geojson_reader.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <deque>
#include <string>

#include "io/geojson_block.h"
#include "io/geojson_rows.h"
#include "io/geojson_schema.h"
#include "io/geojson_text.h"

namespace oblast::io {

namespace {

constexpr std::uint64_t usual_block = 1 << 20;  // bytes: the parsed block stays in the cache
constexpr const char* no_properties = R"({"type":"Feature","properties":{},"geometry":null})";

struct BlockWork {
  GeojsonBlock block;
  LayerBuilder builder;

  explicit BlockWork(const ReadOptions& options) : builder(block.layer, 0, options) {}
  std::size_t features() const { return block.layer.report.features; }
};
using Blocks = std::deque<BlockWork>;

std::uint64_t block_size(const TextSource& text, const ReadOptions& options) {
  if (options.target_crs.empty()) return usual_block;
  // Each block makes a transformation of its own, which takes a while.
  return std::max(usual_block, text.size() / (4 * static_cast<std::uint64_t>(tbb::this_task_arena::max_concurrency())));
}

// True if this reader understood all blocks.
bool read_blocks(const TextSource& text, const GeojsonText& cut, const std::string& crs_wkt, const NamedSource& named,
                 bool keep_values, Blocks& blocks) {
  std::atomic<bool> good = true;
  std::atomic<std::uint64_t> bytes = 0;
  tbb::parallel_for(std::size_t{0}, cut.blocks.size(), [&](std::size_t b) {
    if (!good) return;
    const CPLErrorHandlerPusher quiet(CPLQuietErrorHandler);
    const auto [begin, end] = cut.blocks[b];
    BlockWork& work = blocks[b];
    work.block.layer.files.push_back(named.name);
    std::string array = "[";
    text.append(array, begin, end - begin);
    array += ']';
    try {
      work.builder.set_crs(crs_wkt);
      if (!read_geojson_block(array, {keep_values}, work.builder, work.block)) good = false;
    } catch (const IoError&) {  // GDAL finds it again, with the number of the feature in the file
      good = false;
    }
    if (named.progress) named.progress(static_cast<double>(bytes += end - begin) / static_cast<double>(text.size()));
  });
  const auto differs = [&](const BlockWork& work) {
    return work.block.keys != blocks.front().block.keys || work.block.id_place != blocks.front().block.id_place;
  };
  return good && std::none_of(blocks.begin(), blocks.end(), differs);
}

bool has_twice(std::vector<std::int64_t> ids) {
  std::sort(ids.begin(), ids.end());
  return std::adjacent_find(ids.begin(), ids.end()) != ids.end();
}

// The numbers of the features. Nothing if GDAL would have to find some that are free.
std::optional<std::vector<std::int64_t>> numbers_of(const Blocks& blocks, const GeojsonSchema& schema) {
  std::size_t features = 0;
  for (const BlockWork& work : blocks) features += work.features();
  std::vector<std::int64_t> ids;
  ids.reserve(features);
  const IdPlace place = blocks.front().block.id_place;
  if (place == IdPlace::none || (place == IdPlace::property && schema.id_column.empty())) {
    for (std::size_t f = 0; f < features; ++f) ids.push_back(static_cast<std::int64_t>(f));
    return ids;
  }
  if (place == IdPlace::property) {  // GDAL does not tell "id" from "ID" here
    const auto is_id = [](const std::string& key) { return EQUAL(key.c_str(), "id"); };
    const auto& keys = blocks.front().block.keys;
    if (std::count_if(keys.begin(), keys.end(), is_id) > 1) return std::nullopt;
  }
  for (const BlockWork& work : blocks) ids.insert(ids.end(), work.block.ids.begin(), work.block.ids.end());
  if (ids.size() != features || has_twice(ids)) return std::nullopt;
  return ids;
}

bool read_table(Blocks& blocks, const GeojsonSchema& schema, std::span<const std::int64_t> ids, FileTable& table) {
  std::vector<std::size_t> first;
  std::size_t features = 0;
  for (const BlockWork& work : blocks) {
    first.push_back(features);
    features += work.features();
  }
  std::vector<std::unique_ptr<OGRFeature>> rows(features);
  std::atomic<bool> good = true;
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
    const std::size_t count = blocks[b].features();
    if (!make_rows(blocks[b].block, *schema.definition, ids.subspan(first[b], count),
                   std::span(rows).subspan(first[b], count)))
      good = false;
    blocks[b].block.values = {};
    blocks[b].block.texts = {};
  });
  if (good) table.rows = std::move(rows);
  return good;
}

Layer join(Blocks& blocks, const NamedSource& named, const GeojsonSchema& schema, const ReadOptions& options,
           std::span<const std::int64_t> ids) {
  Layer layer;
  layer.files.push_back(named.name);
  layer.notes = schema.notes;
  LayerBuilder builder(layer, 0, options);
  builder.set_crs(schema.crs_wkt);
  for (BlockWork& work : blocks) {
    builder.append(work.builder, ids);
    ids = ids.subspan(work.features());
    work.block.layer.regions = {};
  }
  builder.finish();
  return layer;
}

}  // namespace

std::optional<Layer> read_geojson(const TextSource& text, const NamedSource& named, const ReadOptions& options,
                                  Attributes attributes, FileTable& table) {
  if (!options.where.empty()) return std::nullopt;
  const std::optional<GeojsonText> cut = cut_geojson(text, block_size(text, options));
  if (!cut) return std::nullopt;
  const std::string sample = no_properties;
  const std::optional<GeojsonSchema> head = geojson_schema(cut->head, {&sample, 1}, named);
  if (!head) return std::nullopt;

  Blocks blocks;
  for (std::size_t b = 0; b < cut->blocks.size(); ++b) blocks.emplace_back(options);
  const bool keep = attributes == Attributes::keep;
  if (!read_blocks(text, *cut, head->crs_wkt, named, keep, blocks)) return std::nullopt;
  std::vector<std::string> samples;
  for (const BlockWork& work : blocks)
    samples.insert(samples.end(), work.block.samples.begin(), work.block.samples.end());
  const std::optional<GeojsonSchema> schema = geojson_schema(cut->head, samples, named);
  if (!schema) return std::nullopt;
  // Features with heights may have another system. Its longitudes are the same, but not how they are transformed.
  if (schema->crs_wkt != head->crs_wkt && !options.target_crs.empty()) return std::nullopt;
  const std::optional<std::vector<std::int64_t>> ids = numbers_of(blocks, *schema);
  if (!ids || (keep && !read_table(blocks, *schema, *ids, table))) return std::nullopt;
  table.columns = schema->columns;
  Layer layer = join(blocks, named, *schema, options, *ids);
  name_columns(layer, table.columns);
  return layer;
}

}  // namespace oblast::io
