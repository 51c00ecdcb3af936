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

// librsvg and cairo bring 30 libraries with them, which take a third of the start of the program to load. Few commands
// draw a PNG, so they are loaded when one does.
struct Libraries {
  template <class Function>
  struct Entry {
    const char* name;
    Function* call = nullptr;
    template <class... Arguments>
    auto operator()(Arguments... arguments) const {
      return call(arguments...);
    }
  };
#define OBLAST_ENTRY(name) \
  Entry<decltype(::name)> name { #name }
  OBLAST_ENTRY(rsvg_handle_new_from_stream_sync);
  OBLAST_ENTRY(rsvg_handle_get_intrinsic_size_in_pixels);
  OBLAST_ENTRY(rsvg_handle_render_document);
  OBLAST_ENTRY(g_memory_input_stream_new_from_data);
  OBLAST_ENTRY(g_object_unref);
  OBLAST_ENTRY(g_error_free);
  OBLAST_ENTRY(cairo_image_surface_create);
  OBLAST_ENTRY(cairo_surface_status);
  OBLAST_ENTRY(cairo_surface_destroy);
  OBLAST_ENTRY(cairo_surface_write_to_png_stream);
  OBLAST_ENTRY(cairo_status_to_string);
  OBLAST_ENTRY(cairo_create);
  OBLAST_ENTRY(cairo_destroy);
#undef OBLAST_ENTRY

  bool loaded = true;

  Libraries() {
    // What librsvg needs is searched as well. It is never unloaded: GLib does not allow that.
    void* const handle = ::dlopen("librsvg-2.so.2", RTLD_LAZY | RTLD_LOCAL | RTLD_NODELETE);
    const auto find = [&](auto&... entries) { loaded = handle && (... && find_one(handle, entries)); };
    find(rsvg_handle_new_from_stream_sync, rsvg_handle_get_intrinsic_size_in_pixels, rsvg_handle_render_document,
         g_memory_input_stream_new_from_data, g_object_unref, g_error_free, cairo_image_surface_create,
         cairo_surface_status, cairo_surface_destroy, cairo_surface_write_to_png_stream, cairo_status_to_string,
         cairo_create, cairo_destroy);
  }

 private:
  template <class Function>
  static bool find_one(void* handle, Entry<Function>& entry) {
    entry.call = reinterpret_cast<Function*>(::dlsym(handle, entry.name));
    return entry.call != nullptr;
  }
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

bool can_draw_png() { return libraries().loaded; }

std::string to_png(const std::string& svg, double scale) {
  const Libraries& use = libraries();
  if (!use.loaded) throw IoError("cannot draw the picture as PNG: librsvg is not installed");
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
