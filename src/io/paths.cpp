// Files; see paths.h.
#include "io/paths.h"

#include <cpl_vsi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "io/layer.h"

namespace oblast::io {

namespace {

bool is_virtual(const std::string& path) { return path.starts_with("/vsi"); }

std::string read_virtual(const std::string& path) {
  GByte* bytes = nullptr;
  vsi_l_offset size = 0;
  if (!VSIIngestFile(nullptr, path.c_str(), &bytes, &size, -1)) throw IoError("cannot read " + path);
  std::string text(reinterpret_cast<const char*>(bytes), size);
  VSIFree(bytes);
  return text;
}

}  // namespace

std::string read_text(const std::string& path) {
  if (is_virtual(path)) return read_virtual(path);
  const auto close = [](std::FILE* f) {
    if (f != stdin) std::fclose(f);
  };
  std::unique_ptr<std::FILE, decltype(close)> file(path == "-" ? stdin : std::fopen(path.c_str(), "rb"), close);
  if (!file) throw CannotOpen("cannot read " + path + ": " + std::strerror(errno));
  std::string text;
  constexpr std::size_t chunk = 1 << 20;
  for (;;) {
    const std::size_t size = text.size();
    text.resize(size + chunk);
    const std::size_t got = std::fread(text.data() + size, 1, chunk, file.get());
    text.resize(size + got);
    if (got < chunk) break;
  }
  if (std::ferror(file.get())) throw IoError("cannot read " + path + ": " + std::strerror(errno));
  return text;
}

bool path_exists(const std::string& path) {
  std::error_code error;
  VSIStatBufL status;
  return is_virtual(path) ? VSIStatL(path.c_str(), &status) == 0 : std::filesystem::exists(path, error);
}

bool is_folder(const std::string& path) {
  std::error_code error;
  VSIStatBufL status;
  if (is_virtual(path)) return VSIStatL(path.c_str(), &status) == 0 && VSI_ISDIR(status.st_mode);
  return std::filesystem::is_directory(path, error);
}

std::uint64_t size_of_file(const std::string& path) {
  VSIStatBufL status;
  return VSIStatL(path.c_str(), &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

std::string name_list(std::span<const std::string> names) {
  constexpr std::size_t most = 5;
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i == most && names.size() > most + 1) return text + fmt::format(" and {} more", names.size() - most);
    if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
    text += names[i];
  }
  return text;
}

}  // namespace oblast::io
