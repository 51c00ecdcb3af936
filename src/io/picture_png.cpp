#include "io/picture_png.h"

#include "io/layer.h"

#ifdef OBLAST_PNG
#include <cairo.h>
#include <dlfcn.h>
#include <librsvg/rsvg.h>

#include <memory>
#endif

namespace oblast::io {

#ifdef OBLAST_PNG

namespace {

// librsvg and cairo bring 30 libraries with them, which take a quarter of the start of the program to load. Few
// commands draw a PNG, so they are loaded when one does.
class Libraries {
 public:
  bool are_loaded() const { return handle_ && loaded_; }

 private:
  template <class Function>
  Function* find(const char* name) {
    auto* const found = handle_ ? reinterpret_cast<Function*>(::dlsym(handle_, name)) : nullptr;
    loaded_ = loaded_ && found;
    return found;
  }

  // What librsvg needs is searched as well. It is never unloaded: GLib does not allow that.
  void* handle_ = ::dlopen("librsvg-2.so.2", RTLD_LAZY | RTLD_LOCAL | RTLD_NODELETE);
  bool loaded_ = true;

 public:
  decltype(::rsvg_handle_new_from_stream_sync)* rsvg_handle_new_from_stream_sync =
      find<decltype(::rsvg_handle_new_from_stream_sync)>("rsvg_handle_new_from_stream_sync");
  decltype(::rsvg_handle_get_intrinsic_size_in_pixels)* rsvg_handle_get_intrinsic_size_in_pixels =
      find<decltype(::rsvg_handle_get_intrinsic_size_in_pixels)>("rsvg_handle_get_intrinsic_size_in_pixels");
  decltype(::rsvg_handle_render_document)* rsvg_handle_render_document =
      find<decltype(::rsvg_handle_render_document)>("rsvg_handle_render_document");
  decltype(::g_memory_input_stream_new_from_data)* g_memory_input_stream_new_from_data =
      find<decltype(::g_memory_input_stream_new_from_data)>("g_memory_input_stream_new_from_data");
  decltype(::g_object_unref)* g_object_unref = find<decltype(::g_object_unref)>("g_object_unref");
  decltype(::g_error_free)* g_error_free = find<decltype(::g_error_free)>("g_error_free");
  decltype(::cairo_image_surface_create)* cairo_image_surface_create =
      find<decltype(::cairo_image_surface_create)>("cairo_image_surface_create");
  decltype(::cairo_surface_status)* cairo_surface_status =
      find<decltype(::cairo_surface_status)>("cairo_surface_status");
  decltype(::cairo_surface_destroy)* cairo_surface_destroy =
      find<decltype(::cairo_surface_destroy)>("cairo_surface_destroy");
  decltype(::cairo_surface_write_to_png_stream)* cairo_surface_write_to_png_stream =
      find<decltype(::cairo_surface_write_to_png_stream)>("cairo_surface_write_to_png_stream");
  decltype(::cairo_status_to_string)* cairo_status_to_string =
      find<decltype(::cairo_status_to_string)>("cairo_status_to_string");
  decltype(::cairo_create)* cairo_create = find<decltype(::cairo_create)>("cairo_create");
  decltype(::cairo_destroy)* cairo_destroy = find<decltype(::cairo_destroy)>("cairo_destroy");
};

const Libraries& libraries() {
  static const Libraries loaded;
  return loaded;
}

struct Free {
  void operator()(RsvgHandle* handle) const { libraries().g_object_unref(handle); }
  void operator()(GInputStream* stream) const { libraries().g_object_unref(stream); }
  void operator()(cairo_surface_t* surface) const { libraries().cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { libraries().cairo_destroy(context); }
};

cairo_status_t append(void* to, const unsigned char* bytes, unsigned size) {
  static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), size);
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw IoError(std::string("cannot draw the picture as PNG: ") + libraries().cairo_status_to_string(status));
}

[[noreturn]] void refuse(GError* error) {
  const std::string message = std::string("cannot draw the picture as PNG: ") + error->message;
  libraries().g_error_free(error);
  throw IoError(message);
}

}  // namespace

bool can_draw_png() { return libraries().are_loaded(); }

std::string to_png(const std::string& svg, double scale) {
  const Libraries& use = libraries();
  if (!use.are_loaded()) throw IoError("cannot draw the picture as PNG: librsvg is not installed");
  GError* error = nullptr;
  const std::unique_ptr<GInputStream, Free> stream(use.g_memory_input_stream_new_from_data(
      svg.data(), static_cast<gssize>(svg.size()), static_cast<GDestroyNotify>(nullptr)));
  // A picture may have more elements and longer paths than a parser of unknown text should accept.
  const std::unique_ptr<RsvgHandle, Free> handle(
      use.rsvg_handle_new_from_stream_sync(stream.get(), nullptr, RSVG_HANDLE_FLAG_UNLIMITED, nullptr, &error));
  if (!handle) refuse(error);
  double width = 0, height = 0;
  use.rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &width, &height);
  const RsvgRectangle page{0, 0, width * scale, height * scale};
  const std::unique_ptr<cairo_surface_t, Free> surface(
      use.cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(page.width), static_cast<int>(page.height)));
  check(use.cairo_surface_status(surface.get()));
  const std::unique_ptr<cairo_t, Free> context(use.cairo_create(surface.get()));
  if (!use.rsvg_handle_render_document(handle.get(), context.get(), &page, &error)) refuse(error);
  std::string png;
  check(use.cairo_surface_write_to_png_stream(surface.get(), append, &png));
  return png;
}

#else

bool can_draw_png() { return false; }

std::string to_png(const std::string&, double) { throw IoError("this program was built without librsvg"); }

#endif

}  // namespace oblast::io
