// By the first bytes; see standard_input.h.
#include "io/standard_input.h"

#include <cpl_vsi.h>

#include <cctype>
#include <utility>

#include "io/layer.h"

namespace oblast::io {

ContentKind kind_of_content(const std::string& text) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  std::string_view rest = text;
  if (rest.starts_with(byte_order_mark)) rest.remove_prefix(byte_order_mark.size());
  // Before white space is skipped: WKB begins with a byte 0 or 1, and so does no text.
  if (!rest.empty() && (rest.front() == '\0' || rest.front() == '\1')) return ContentKind::wkb;
  for (const auto& [begin, what] : {std::pair<std::string_view, const char*>{"SQLite format 3", "a GeoPackage"},
                                    {"fgb\x03", "FlatGeobuf"},
                                    {"PK\x03\x04", "a .zip archive"},
                                    {"PAR1", "Parquet"}}) {
    if (rest.starts_with(begin))
      throw IoError(std::string("standard input has ") + what +
                    "; only GeoJSON, WKT and WKB are read from there: save it as a file, and name that");
  }
  constexpr char record_separator = '\x1e';  // of GeoJSON text sequences
  while (!rest.empty() && (std::isspace(static_cast<unsigned char>(rest.front())) || rest.front() == record_separator))
    rest.remove_prefix(1);
  if (rest.empty()) throw IoError("standard input is empty; give it WKT, WKB or GeoJSON");
  if (rest.front() == '{') return ContentKind::json;
  if (rest.starts_with("00") || rest.starts_with("01")) return ContentKind::wkb;
  return ContentKind::wkt;
}

MemoryFile::MemoryFile(std::string text, const std::string& name)
    : text_(std::move(text)), path_("/vsimem/oblast/" + name) {
  VSILFILE* file = VSIFileFromMemBuffer(path_.c_str(), reinterpret_cast<GByte*>(text_.data()), text_.size(), FALSE);
  if (!file) throw IoError("cannot keep standard input in memory");
  VSIFCloseL(file);
}

MemoryFile::~MemoryFile() { VSIUnlink(path_.c_str()); }

}  // namespace oblast::io
