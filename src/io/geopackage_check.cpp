// The header of SQLite's files; see geopackage_check.h.
#include "io/geopackage_check.h"

#include <fmt/format.h>

#include <cstdint>
#include <string_view>

#include "io/layer.h"
#include "io/paths.h"
#include "io/text_source.h"

namespace oblast::io {

namespace {

std::uint32_t big_endian(std::string_view bytes) {
  std::uint32_t number = 0;
  for (const char byte : bytes) number = number << 8 | static_cast<unsigned char>(byte);
  return number;
}

}  // namespace

// https://www.sqlite.org/fileformat.html, 1.3: the size of pages at 16, the number of pages at 28, valid if the
// counters at 24 and 92 are equal.
void check_geopackage(const std::string& path) {
  if (path.starts_with("/vsi") || path_exists(path + "-wal")) return;
  const TextSource file(path);
  const std::string bytes = file.read(0, 100);
  const std::string_view head = bytes;
  if (head.size() < 100 || !head.starts_with("SQLite format 3") || head.substr(24, 4) != head.substr(92, 4)) return;
  const std::uint64_t page = big_endian(head.substr(16, 2)) == 1 ? 65536 : big_endian(head.substr(16, 2));
  const std::uint64_t size = page * big_endian(head.substr(28, 4));
  if (file.size() < size)
    throw IoError(
        fmt::format("{} is truncated: its header declares {} bytes, but it has {}; copy or export the file "
                    "again",
                    path, size, file.size()));
}

}  // namespace oblast::io
