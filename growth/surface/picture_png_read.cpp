// Pixels through libpng's simplified interface.

#include "growth/surface/picture_png_read.h"

#include <png.h>

#include "scene/input_error.h"

namespace rinceau {
namespace {

constexpr std::uint64_t most_pixels = 16'000'000;

/// What libpng reads with, given up at the end.
struct PngPixels {
    png_image image{};
    PngPixels() { image.version = PNG_IMAGE_VERSION; }
    PngPixels(const PngPixels&) = delete;
    PngPixels& operator=(const PngPixels&) = delete;
    ~PngPixels() { png_image_free(&image); }
};

}  // namespace

Picture read_picture_png(std::string_view bytes, const std::string& label) {
    PngPixels png;
    png_image& image = png.image;
    const auto expect = [&](int ok) {
        if (ok == 0) throw InputError({label}, std::string("expected a PNG picture: ") + image.message);
    };
    expect(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()));
    if (std::uint64_t{image.width} * image.height > most_pixels)
        throw LimitError({label}, "the picture has more than " + std::to_string(most_pixels) + " pixels; make it smaller");
    image.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // what says nothing of its values is as bright as it would be with 8 bits
    image.format = PNG_FORMAT_RGB;
    Picture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
    picture.rgb.resize(PNG_IMAGE_SIZE(image));
    const png_color white{255, 255, 255};
    expect(png_image_finish_read(&image, &white, picture.rgb.data(), 0, nullptr));
    return picture;
}

}  // namespace rinceau
