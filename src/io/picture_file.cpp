// Checks the call, and writes; see picture_file.h.
#include "io/picture_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "io/formats.h"
#include "io/layer.h"
#include "io/picture_png.h"
#include "io/staged_output.h"
#include "io/write_text.h"

namespace oblast::io {

namespace fs = std::filesystem;

namespace {

constexpr double pixels_of_a_unit = 2;

void check_format(const std::string& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".svg") return;
  if (extension != ".png")
    throw IoError("cannot draw " + path + ": " +
                  (extension.empty() ? "its name has no extension" : extension + " is not a format of pictures") +
                  "; choose a name that ends in .svg or .png");
  if (!can_draw_png())
    throw IoError("cannot draw " + path +
                  ": librsvg, which draws PNG, is not there; install it (package librsvg2-2), or choose .svg");
}

}  // namespace

void check_picture_writable(const std::string& path, Existing existing) {
  if (path == "-") return;
  check_format(path);
  std::error_code error;
  const fs::path parent = fs::path(path).has_parent_path() ? fs::path(path).parent_path() : fs::path(".");
  if (!fs::is_directory(parent, error))
    throw IoError("cannot write " + path + ": there is no folder " + parent.string() + "; create it first");
  if (fs::is_directory(path, error)) throw IoError("cannot write " + path + ": it is a folder");
  if (existing == Existing::refuse && fs::exists(fs::symlink_status(path, error)))
    throw IoError(path + " exists already (--overwrite replaces it)");
  if (::access(parent.c_str(), W_OK | X_OK) != 0)
    throw IoError("cannot write into " + parent.string() + ": " + std::strerror(errno));
}

void write_picture(const std::string& path, const std::string& svg, Existing existing) {
  check_picture_writable(path, existing);
  if (path == "-") return write_text_to_standard_output(svg);
  const std::string bytes = lower_extension(path) == ".png" ? to_png(svg, pixels_of_a_unit) : svg;
  StagedOutput stage(path, {});
  write_text(stage.path(), bytes, path);
  stage.commit();
}

}  // namespace oblast::io
