// Bytes of a file or of a text in memory, read piece by piece.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace oblast::io {

class TextSource {
 public:
  /// The text must outlive this object. Messages call it `name`.
  TextSource(std::string_view text, std::string name);
  /// Opens a regular file. Throws IoError.
  explicit TextSource(const std::string& path);
  ~TextSource();
  TextSource(const TextSource&) = delete;
  TextSource& operator=(const TextSource&) = delete;

  std::uint64_t size() const { return size_; }
  const std::string& name() const { return name_; }
  /// Appends the bytes [begin, begin + count), or as many of them as there are. Several threads may call it. Throws
  /// IoError.
  void append(std::string& to, std::uint64_t begin, std::uint64_t count) const;
  std::string read(std::uint64_t begin, std::uint64_t count) const {
    std::string bytes;
    append(bytes, begin, count);
    return bytes;
  }

 private:
  std::string_view text_;
  std::string name_;
  int file_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace oblast::io
