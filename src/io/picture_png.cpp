#include "io/picture_png.h"

#include "io/layer.h"

#ifdef OBLAST_PNG
#include <cairo.h>
#include <librsvg/rsvg.h>

#include <memory>
#endif

namespace oblast::io {

#ifdef OBLAST_PNG

namespace {

struct Free {
  void operator()(RsvgHandle* handle) const { g_object_unref(handle); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};

cairo_status_t append(void* to, const unsigned char* bytes, unsigned size) {
  static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), size);
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw IoError(std::string("cannot draw the picture as PNG: ") + cairo_status_to_string(status));
}

}  // namespace

bool can_draw_png() { return true; }

std::string to_png(const std::string& svg, double scale) {
  const auto refuse = [](GError* error) {
    const std::string message = std::string("cannot draw the picture as PNG: ") + error->message;
    g_error_free(error);
    throw IoError(message);
  };
  GError* error = nullptr;
  GInputStream* stream = g_memory_input_stream_new_from_data(svg.data(), static_cast<gssize>(svg.size()), nullptr);
  // A picture may have more elements and longer paths than a parser of unknown text should accept.
  const std::unique_ptr<RsvgHandle, Free> handle(
      rsvg_handle_new_from_stream_sync(stream, nullptr, RSVG_HANDLE_FLAG_UNLIMITED, nullptr, &error));
  g_object_unref(stream);
  if (!handle) refuse(error);
  double width = 0, height = 0;
  rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &width, &height);
  const RsvgRectangle page{0, 0, width * scale, height * scale};
  const std::unique_ptr<cairo_surface_t, Free> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(page.width), static_cast<int>(page.height)));
  check(cairo_surface_status(surface.get()));
  const std::unique_ptr<cairo_t, Free> context(cairo_create(surface.get()));
  if (!rsvg_handle_render_document(handle.get(), context.get(), &page, &error)) refuse(error);
  std::string png;
  check(cairo_surface_write_to_png_stream(surface.get(), append, &png));
  return png;
}

#else

bool can_draw_png() { return false; }

std::string to_png(const std::string&, double) { throw IoError("this program was built without librsvg"); }

#endif

}  // namespace oblast::io
