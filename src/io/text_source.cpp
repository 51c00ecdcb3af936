// Positioned reads; see text_source.h. A mapped file would end the program if another one shortens it.
#include "io/text_source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "io/layer.h"

namespace oblast::io {

namespace {

[[noreturn]] void cannot_read(const std::string& name) {
  throw IoError("cannot read " + name + ": " + std::strerror(errno));
}

}  // namespace

TextSource::TextSource(std::string_view text, std::string name)
    : text_(text), name_(std::move(name)), size_(text.size()) {}

TextSource::TextSource(const std::string& path) : name_(path), file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
  struct stat status = {};
  if (file_ < 0 || ::fstat(file_, &status) != 0) cannot_read(name_);
  size_ = static_cast<std::uint64_t>(status.st_size);
}

TextSource::~TextSource() {
  if (file_ >= 0) ::close(file_);
}

void TextSource::append(std::string& to, std::uint64_t begin, std::uint64_t count) const {
  count = begin < size_ ? std::min(count, size_ - begin) : 0;
  if (file_ < 0) {
    to.append(text_.substr(begin, count));
    return;
  }
  std::size_t at = to.size();
  to.resize(at + count);
  while (count > 0) {
    const ssize_t got = ::pread(file_, to.data() + at, count, static_cast<off_t>(begin));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) cannot_read(name_);
    if (got == 0) break;  // shortened by another program
    at += static_cast<std::size_t>(got);
    begin += static_cast<std::uint64_t>(got);
    count -= static_cast<std::uint64_t>(got);
  }
  to.resize(at);
}

}  // namespace oblast::io
