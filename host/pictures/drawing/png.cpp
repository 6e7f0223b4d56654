#include "host/pictures/drawing/png.hpp"

#include <cairo.h>
#include <librsvg/rsvg.h>

#include <cmath>
#include <memory>

#include "host/base/error.hpp"

namespace brdftab::drawing {
namespace {

constexpr double pixels_per_unit = 2.5;

using CairoSurface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

CairoSurface new_surface(cairo_format_t format, int width, int height) {
  CairoSurface surface(cairo_image_surface_create(format, width, height), cairo_surface_destroy);
  if (const auto status = cairo_surface_status(surface.get()); status != CAIRO_STATUS_SUCCESS)
    throw Error(Fault::check, "a picture of {} x {} pixels cannot be made: {}", width, height,
                cairo_status_to_string(status));
  return surface;
}

std::vector<std::byte> encoded(cairo_surface_t* surface) {
  std::vector<std::byte> bytes;
  const auto status = cairo_surface_write_to_png_stream(
      surface,
      [](void* out, const unsigned char* data, unsigned length) {
        const auto* begin = reinterpret_cast<const std::byte*>(data);
        static_cast<std::vector<std::byte>*>(out)->insert(static_cast<std::vector<std::byte>*>(out)->end(),
                                                          begin, begin + length);
        return CAIRO_STATUS_SUCCESS;
      },
      &bytes);
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(Fault::check, "PNG cannot be made: {}", cairo_status_to_string(status));
  return bytes;
}

}  // namespace

std::vector<std::byte> png(const Raster& raster) {
  const CairoSurface surface =
      new_surface(CAIRO_FORMAT_ARGB32, static_cast<int>(raster.width), static_cast<int>(raster.height));
  unsigned char* const data = cairo_image_surface_get_data(surface.get());
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  for (std::size_t row = 0; row < raster.height; ++row) {
    auto* const pixels = reinterpret_cast<std::uint32_t*>(data + row * stride);
    for (std::size_t column = 0; column < raster.width; ++column) {
      const auto& pixel = raster.pixels[row * raster.width + column];
      pixels[column] =
          pixel ? 0xff000000u | static_cast<std::uint32_t>(pixel->red << 16 | pixel->green << 8 | pixel->blue)
                : 0;
    }
  }
  cairo_surface_mark_dirty(surface.get());
  return encoded(surface.get());
}

std::vector<std::byte> png_of_svg(std::string_view svg, int width) {
  GError* error = nullptr;
  const std::unique_ptr<GInputStream, decltype(&g_object_unref)> stream(
      g_memory_input_stream_new_from_data(svg.data(), static_cast<gssize>(svg.size()), nullptr),
      g_object_unref);
  const std::unique_ptr<RsvgHandle, decltype(&g_object_unref)> handle(
      rsvg_handle_new_from_stream_sync(stream.get(), nullptr, RSVG_HANDLE_FLAG_UNLIMITED, nullptr, &error),
      g_object_unref);
  const auto check = [&](bool good) {
    if (good) return;
    const std::unique_ptr<GError, decltype(&g_error_free)> owned(error, g_error_free);
    throw Error(Fault::check, "librsvg cannot draw the picture: {}", error ? error->message : "");
  };
  check(handle != nullptr);
  double natural_width = 0, natural_height = 0;
  check(rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &natural_width, &natural_height));
  if (width == 0) width = static_cast<int>(std::lround(pixels_per_unit * natural_width));
  const int height = static_cast<int>(std::lround(width * natural_height / natural_width));
  const CairoSurface surface = new_surface(CAIRO_FORMAT_ARGB32, width, height);
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context(cairo_create(surface.get()),
                                                                   cairo_destroy);
  const RsvgRectangle viewport{0, 0, static_cast<double>(width), static_cast<double>(height)};
  check(rsvg_handle_render_document(handle.get(), context.get(), &viewport, &error));
  cairo_surface_flush(surface.get());
  return encoded(surface.get());
}

}  // namespace brdftab::drawing
