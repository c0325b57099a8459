#include "scene/svg_raster.h"

#include <cairo-pdf.h>
#include <cairo.h>
#include <librsvg/rsvg.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <memory>
#include <new>

#include "scene/input_error.h"

namespace rinceau {

namespace {

constexpr double px_per_inch = 96;
constexpr double points_per_px = 72 / px_per_inch;
constexpr double largest_side = 32767;  // of a cairo image

template <auto release>
struct Release {
    template <class T>
    void operator()(T* object) const {
        release(object);
    }
};
using Handle = std::unique_ptr<RsvgHandle, Release<g_object_unref>>;
using Surface = std::unique_ptr<cairo_surface_t, Release<cairo_surface_destroy>>;
using Context = std::unique_ptr<cairo_t, Release<cairo_destroy>>;
using Stream = std::unique_ptr<GInputStream, Release<g_object_unref>>;
using Failure = std::unique_ptr<GError, Release<g_error_free>>;

[[noreturn]] void refuse(GError* error) {
    const Failure failure(error);
    throw InputError({},
                     std::string("the renderer refuses the document: ") + (failure ? failure->message : "no reason given"));
}

Handle open_document(std::string_view svg) {
    GError* error = nullptr;
    const Stream stream(g_memory_input_stream_new_from_data(svg.data(), static_cast<gssize>(svg.size()), nullptr));
    Handle handle(rsvg_handle_new_from_stream_sync(stream.get(), nullptr, RSVG_HANDLE_FLAG_UNLIMITED, nullptr, &error));
    if (!handle) refuse(error);
    rsvg_handle_set_dpi(handle.get(), px_per_inch);
    return handle;
}

struct Size {
    double width = 0, height = 0;  // px
};

// The document's own size, else that of its view box, else as far as it draws.
Size document_size(RsvgHandle* handle) {
    Size size;
    if (rsvg_handle_get_intrinsic_size_in_pixels(handle, &size.width, &size.height)) return size;
    gboolean has_width = 0, has_height = 0, has_view_box = 0;
    RsvgLength unused_width, unused_height;
    RsvgRectangle box{};
    rsvg_handle_get_intrinsic_dimensions(handle, &has_width, &unused_width, &has_height, &unused_height, &has_view_box,
                                         &box);
    if (has_view_box) return {box.width, box.height};
    RsvgRectangle ink{};
    GError* error = nullptr;
    if (!rsvg_handle_get_geometry_for_element(handle, nullptr, &ink, nullptr, &error)) refuse(error);
    return {ink.x + ink.width, ink.y + ink.height};
}

void render(RsvgHandle* handle, cairo_surface_t* surface, Size size) {
    const Context context(cairo_create(surface));
    const RsvgRectangle viewport{0, 0, size.width, size.height};
    GError* error = nullptr;
    if (!rsvg_handle_render_document(handle, context.get(), &viewport, &error)) refuse(error);
}

// Exceptions do not pass through cairo.
cairo_status_t append_bytes(void* target, const unsigned char* bytes, unsigned int count) noexcept {
    try {
        static_cast<std::string*>(target)->append(reinterpret_cast<const char*>(bytes), count);
        return CAIRO_STATUS_SUCCESS;
    } catch (const std::bad_alloc&) {
        return CAIRO_STATUS_NO_MEMORY;
    }
}

void require_success(cairo_status_t status) {
    if (status == CAIRO_STATUS_NO_MEMORY)
        throw LimitError({}, "the memory does not suffice for the picture; ask for a smaller width");
    if (status != CAIRO_STATUS_SUCCESS) throw LimitError({}, std::string("no picture: ") + cairo_status_to_string(status));
}

}  // namespace

namespace {

Surface rendered(std::string_view svg, int width) {
    const Handle handle = open_document(svg);
    Size size = document_size(handle.get());
    if (width > 0 && size.width > 0) size = {static_cast<double>(width), size.height * width / size.width};
    // A document without extent still gives a picture, of one transparent pixel.
    const Size pixels{std::max(1.0, std::ceil(size.width)), std::max(1.0, std::ceil(size.height))};
    if (!(pixels.width <= largest_side && pixels.height <= largest_side)) {
        throw LimitError({}, "the picture would exceed 32767 pixels a side; ask for a smaller width");
    }
    Surface surface(
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, static_cast<int>(pixels.width), static_cast<int>(pixels.height)));
    require_success(cairo_surface_status(surface.get()));
    render(handle.get(), surface.get(), size);
    return surface;
}

}  // namespace

std::string svg_to_png(std::string_view svg, int width) {
    const Surface surface = rendered(svg, width);
    std::string png;
    require_success(cairo_surface_write_to_png_stream(surface.get(), append_bytes, &png));
    return png;
}

Picture svg_to_picture(std::string_view svg, int width) {
    const Surface surface = rendered(svg, width);
    cairo_surface_flush(surface.get());
    Picture picture{cairo_image_surface_get_width(surface.get()), cairo_image_surface_get_height(surface.get()), {}};
    const unsigned char* rows = cairo_image_surface_get_data(surface.get());
    const auto stride = static_cast<std::ptrdiff_t>(cairo_image_surface_get_stride(surface.get()));
    picture.rgb.reserve(std::size_t{3} * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            std::uint32_t pixel = 0;  // alpha, red, green, blue from the top byte down; colours premultiplied
            std::memcpy(&pixel, rows + y * stride + std::ptrdiff_t{4} * x, sizeof pixel);
            const std::uint32_t white = 255 - (pixel >> 24U);
            for (const unsigned shift : {16U, 8U, 0U}) {
                picture.rgb.push_back(
                    static_cast<std::uint8_t>(std::min<std::uint32_t>(255, ((pixel >> shift) & 255U) + white)));
            }
        }
    }
    return picture;
}

std::string picture_to_png(const Picture& picture) {
    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.width, picture.height));
    require_success(cairo_surface_status(surface.get()));
    unsigned char* rows = cairo_image_surface_get_data(surface.get());
    const auto stride = static_cast<std::ptrdiff_t>(cairo_image_surface_get_stride(surface.get()));
    const std::uint8_t* from = picture.rgb.data();
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x, from += 3) {
            const std::uint32_t pixel =
                static_cast<std::uint32_t>(from[0]) << 16U | static_cast<std::uint32_t>(from[1]) << 8U | from[2];
            std::memcpy(rows + y * stride + std::ptrdiff_t{4} * x, &pixel, sizeof pixel);
        }
    }
    cairo_surface_mark_dirty(surface.get());
    std::string png;
    require_success(cairo_surface_write_to_png_stream(surface.get(), append_bytes, &png));
    return png;
}

TransparentPicture svg_to_transparent_picture(std::string_view svg, int width) {
    const Surface surface = rendered(svg, width);
    cairo_surface_flush(surface.get());
    TransparentPicture picture{
        cairo_image_surface_get_width(surface.get()), cairo_image_surface_get_height(surface.get()), {}};
    const unsigned char* rows = cairo_image_surface_get_data(surface.get());
    const auto stride = static_cast<std::ptrdiff_t>(cairo_image_surface_get_stride(surface.get()));
    picture.rgba.reserve(std::size_t{4} * static_cast<std::size_t>(picture.width) *
                         static_cast<std::size_t>(picture.height));
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            std::uint32_t pixel = 0;  // as above
            std::memcpy(&pixel, rows + y * stride + std::ptrdiff_t{4} * x, sizeof pixel);
            for (const unsigned shift : {16U, 8U, 0U, 24U})
                picture.rgba.push_back(static_cast<std::uint8_t>(pixel >> shift));
        }
    }
    return picture;
}

std::string svg_to_pdf(std::string_view svg) {
    const Handle handle = open_document(svg);
    const Size size = document_size(handle.get());
    const Size page{points_per_px * size.width, points_per_px * size.height};
    std::string pdf;
    const Surface surface(cairo_pdf_surface_create_for_stream(append_bytes, &pdf, page.width, page.height));
    require_success(cairo_surface_status(surface.get()));
    // The same bytes every time: no date of today.
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "1970-01-01T00:00:00Z");
    render(handle.get(), surface.get(), page);
    cairo_surface_finish(surface.get());
    require_success(cairo_surface_status(surface.get()));
    return pdf;
}

}  // namespace rinceau
