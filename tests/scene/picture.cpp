#include "picture.h"

#include <cairo.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

#include "scene/svg_raster.h"

namespace rinceau {
namespace {

using Pixel = std::array<int, 3>;

struct Shot {
    int width = 0, height = 0;
    std::vector<Pixel> pixels;
    const Pixel& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)]; }
};

struct Reading {
    const std::string& bytes;
    std::size_t at = 0;
};

cairo_status_t read_bytes(void* closure, unsigned char* data, unsigned length) {
    Reading& reading = *static_cast<Reading*>(closure);
    if (reading.at + length > reading.bytes.size()) return CAIRO_STATUS_READ_ERROR;
    std::memcpy(data, reading.bytes.data() + reading.at, length);
    reading.at += length;
    return CAIRO_STATUS_SUCCESS;
}

Shot picture_of(const std::string& svg, int width) {
    const std::string png = svg_to_png(svg, width);
    Reading reading{png};
    const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
        cairo_image_surface_create_from_png_stream(read_bytes, &reading), cairo_surface_destroy);
    Shot picture{cairo_image_surface_get_width(surface.get()), cairo_image_surface_get_height(surface.get()), {}};
    const unsigned char* data = cairo_image_surface_get_data(surface.get());
    const int stride = cairo_image_surface_get_stride(surface.get());
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            std::uint32_t argb = 0;
            std::memcpy(&argb, data + y * stride + x * 4, sizeof argb);
            const int white = 255 - static_cast<int>(argb >> 24);
            picture.pixels.push_back({static_cast<int>(argb >> 16 & 255) + white, static_cast<int>(argb >> 8 & 255) + white,
                                      static_cast<int>(argb & 255) + white});
        }
    return picture;
}

constexpr int visible_step = 32;   // an eighth of the range
constexpr int inked_below = 250;

bool inked(const Pixel& pixel) { return *std::ranges::min_element(pixel) < inked_below; }

bool far_from_all_near(const Pixel& pixel, const Shot& other, int x, int y) {
    for (int ny = std::max(0, y - 1); ny <= std::min(other.height - 1, y + 1); ++ny)
        for (int nx = std::max(0, x - 1); nx <= std::min(other.width - 1, x + 1); ++nx) {
            const Pixel& near = other.at(nx, ny);
            int step = 0;
            for (std::size_t c = 0; c < 3; ++c) step = std::max(step, std::abs(pixel[c] - near[c]));
            if (step <= visible_step) return false;
        }
    return true;
}

}  // namespace

double picture_difference(const std::string& svg, const std::string& other_svg, int width) {
    const Shot a = picture_of(svg, width), b = picture_of(other_svg, width);
    if (a.height != b.height) return 1;
    int ink = 0, different = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            if (inked(a.at(x, y)) || inked(b.at(x, y))) ++ink;
            if (far_from_all_near(a.at(x, y), b, x, y) || far_from_all_near(b.at(x, y), a, x, y)) ++different;
        }
    return ink == 0 ? 0 : static_cast<double>(different) / ink;
}

}  // namespace rinceau
