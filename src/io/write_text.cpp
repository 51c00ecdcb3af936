// Text into a file; see write_text.h.
#include "io/write_text.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "io/layer.h"

namespace oblast::io {

void write_text(const std::string& path, const std::string& text, const std::string& name) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file) throw IoError("cannot write " + name + ": " + std::strerror(errno));
  errno = 0;
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0;
  const int error = errno;
  const bool closed = std::fclose(file) == 0;  // network file systems report a full disk here
  if (!written || !closed) throw IoError("cannot write " + name + ": " + std::strerror(written ? errno : error));
}

void write_text_to_standard_output(const std::string& text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw IoError(std::string("cannot write to standard output: ") + std::strerror(errno));
  }
}

}  // namespace oblast::io
