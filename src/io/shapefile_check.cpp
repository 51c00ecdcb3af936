// The headers of a shapefile (ESRI Shapefile Technical Description, 1998, pages 3, 4 and 23) and of its
// table (dBASE level 5).
#include "io/shapefile_check.h"

#include <cpl_vsi.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <memory>

#include "io/layer.h"
#include "io/paths.h"

namespace oblast::io {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t header_bytes = 100;
constexpr std::uint64_t index_record_bytes = 8;
constexpr std::uint32_t file_code = 9994;
constexpr std::int32_t multipatch = 31;

using Header = std::array<unsigned char, header_bytes>;

std::uint32_t big_endian(const Header& header, std::size_t at) {
  return std::uint32_t{header[at]} << 24 | std::uint32_t{header[at + 1]} << 16 | std::uint32_t{header[at + 2]} << 8 |
         header[at + 3];
}

std::int32_t little_endian(const Header& header, std::size_t at) {
  return static_cast<std::int32_t>(std::uint32_t{header[at + 3]} << 24 | std::uint32_t{header[at + 2]} << 16 |
                                   std::uint32_t{header[at + 1]} << 8 | header[at]);
}

// Returns how many of the bytes there are.
std::uint64_t read_head(const std::string& path, Header& header, std::size_t bytes) {
  const auto close = [](VSILFILE* file) { VSIFCloseL(file); };
  const std::unique_ptr<VSILFILE, decltype(close)> file(VSIFOpenL(path.c_str(), "rb"), close);
  if (!file) throw IoError("cannot open " + path);
  return VSIFReadL(header.data(), 1, bytes, file.get());
}

// Reads the header of a .shp or .shx and returns it with the length it declares, in bytes.
std::pair<Header, std::uint64_t> checked_header(const std::string& path) {
  Header header{};
  const std::uint64_t got = read_head(path, header, header_bytes);
  if (got < header_bytes)
    throw IoError(
        fmt::format("{} is truncated: it has {} bytes, fewer than the header of a shapefile; copy or export it "
                    "again",
                    path, got));
  if (big_endian(header, 0) != file_code) throw IoError(path + " is not a shapefile: its header has another file code");
  const std::uint64_t declared = 2 * std::uint64_t{big_endian(header, 24)};  // given in 16-bit words
  const std::uint64_t size = size_of_file(path);
  if (size < declared) {
    throw IoError(
        fmt::format("{} is truncated: its header declares {} bytes, but the file has {}; copy or export it again", path,
                    declared, size));
  }
  return {header, declared};
}

// The table must be complete and have as many records as the index. Otherwise a file of the set is older than the
// others or was cut off, and it is unknown which shapes are right.
void check_table(const std::string& path, const std::string& index, std::uint64_t shapes) {
  constexpr std::size_t table_header_bytes = 32;
  Header header{};
  if (read_head(path, header, table_header_bytes) < table_header_bytes)
    throw IoError(path + " is truncated: it has fewer bytes than the header of a table; copy or export it again");
  const auto records = static_cast<std::uint32_t>(little_endian(header, 4));
  const auto lengths = static_cast<std::uint32_t>(little_endian(header, 8));  // two 16-bit numbers
  const std::uint64_t declared = (lengths & 0xffff) + std::uint64_t{records} * (lengths >> 16);
  const std::uint64_t size = size_of_file(path);
  if (size < declared) {
    throw IoError(
        fmt::format("{} is truncated: its header declares {} bytes, but the file has {}; copy or export it again", path,
                    declared, size));
  }
  if (records != shapes) {
    throw IoError(fmt::format(
        "{} has {} records, but {} has {}: the files do not belong together; copy or export all of them again", path,
        records, index, shapes));
  }
}

}  // namespace

std::string find_sibling(const std::string& path, const std::string& extension) {
  std::string upper = extension;
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  for (const std::string& candidate : {extension, upper}) {
    const std::string sibling = fs::path(path).replace_extension(candidate).string();
    if (path_exists(sibling)) return sibling;
  }
  return {};
}

void check_shapefile(const std::string& path) {
  const auto [header, length] = checked_header(path);
  const std::string index = find_sibling(path, ".shx");
  if (index.empty())
    throw IoError(path + " has no .shx file beside it: the shapefile is incomplete; add the .shx file");
  const auto [index_header, index_length] = checked_header(index);
  if (little_endian(header, 32) == multipatch) {
    throw IoError(path + " has MULTIPATCH surfaces, not polygons of the plane; convert them to polygons first");
  }
  const std::string table = find_sibling(path, ".dbf");
  if (!table.empty()) {
    check_table(table, index, (std::max(index_length, header_bytes) - header_bytes) / index_record_bytes);
  }
}

}  // namespace oblast::io
