// Pixels through libpng's simplified interface: grey and opacity in 256 steps whatever the file holds, which is as fine as a
// density can be told.

#include "growth/aggregate/density_picture_png.h"

#include <png.h>

#include <cstdint>

#include "scene/input_error.h"

namespace rinceau {
namespace {

constexpr std::uint64_t most_pixels = 16'000'000;

/// The picture that libpng reads, given up at the end.
struct PngImage {
    png_image image{};
    PngImage() { image.version = PNG_IMAGE_VERSION; }
    PngImage(const PngImage&) = delete;
    PngImage& operator=(const PngImage&) = delete;
    ~PngImage() { png_image_free(&image); }
};

}  // namespace

DensityPicture read_density_png(std::string_view bytes, const Box& box, const std::string& label) {
    PngImage png;
    png_image& image = png.image;
    const auto expect = [&](int ok) {
        if (ok == 0) throw InputError({label}, std::string("expected a PNG picture: ") + image.message);
    };
    expect(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()));
    if (std::uint64_t{image.width} * image.height > most_pixels)
        throw LimitError({label}, "the picture has more than " + std::to_string(most_pixels) + " pixels; make it smaller");
    image.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // what says nothing of its values is as bright as it would be with 8 bits
    image.format = PNG_FORMAT_GA;
    constexpr std::size_t channels = 2;
    const std::size_t count = std::size_t{image.width} * image.height;
    std::vector<std::uint8_t> pixels(channels * count);
    expect(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr));

    DensityPicture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}, box};
    picture.values.reserve(count);
    constexpr double full = 255;
    for (std::size_t i = 0; i < count; ++i) {
        const double grey = pixels[channels * i] / full, opacity = pixels[channels * i + 1] / full;
        picture.values.push_back(opacity * (1 - grey));  // over white
    }
    return picture;
}

}  // namespace rinceau
