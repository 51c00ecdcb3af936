// What standard input has: its format is found in the data, because there is no name.
#pragma once

#include <string>

namespace oblast::io {

enum class ContentKind { wkt, wkb, json };

/// WKB may be in hexadecimal digits. Anything that is not known is taken for WKT, whose reader says what is wrong.
/// Throws IoError if there is nothing but white space, or if the data is a file that must have a name.
ContentKind kind_of_content(const std::string& text);

/// A file in memory, under a virtual path of GDAL.
class MemoryFile {
 public:
  /// `name` is unique among the files that exist at one time.
  MemoryFile(std::string text, const std::string& name);
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  const std::string& path() const { return path_; }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::string path_;
};

}  // namespace oblast::io
