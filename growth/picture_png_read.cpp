// Pixels through libpng's simplified interface.

#include "growth/picture_png_read.h"

#include <png.h>

#include "scene/input_error.h"

namespace rinceau {
namespace {

constexpr std::uint64_t most_pixels = 16'000'000;

/// What libpng reads with, given up at the end.
class PngReader {
  public:
    PngReader(std::string_view bytes, const std::string& label, png_uint_32 format) : label_(label) {
        image_.version = PNG_IMAGE_VERSION;
        expect(png_image_begin_read_from_memory(&image_, bytes.data(), bytes.size()));
        if (std::uint64_t{image_.width} * image_.height > most_pixels) {
            png_image_free(&image_);
            throw LimitError({label},
                             "the picture has more than " + std::to_string(most_pixels) + " pixels; make it smaller");
        }
        image_.flags |=
            PNG_IMAGE_FLAG_16BIT_sRGB;  // what says nothing of its values is as bright as it would be with 8 bits
        image_.format = format;
    }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
    ~PngReader() { png_image_free(&image_); }

    int width() const { return static_cast<int>(image_.width); }
    int height() const { return static_cast<int>(image_.height); }

    /// What is not opaque lies over the background, if the format has no opacity.
    std::vector<std::uint8_t> pixels(const png_color* background) {
        std::vector<std::uint8_t> values(PNG_IMAGE_SIZE(image_));
        expect(png_image_finish_read(&image_, background, values.data(), 0, nullptr));
        return values;
    }

  private:
    png_image image_{};
    const std::string& label_;

    /// libpng frees what it holds when it fails.
    void expect(int ok) const {
        if (ok == 0) throw InputError({label_}, std::string("expected a PNG picture: ") + image_.message);
    }
};

}  // namespace

Picture read_picture_png(std::string_view bytes, const std::string& label) {
    PngReader reader(bytes, label, PNG_FORMAT_RGB);
    const png_color white{255, 255, 255};
    return {reader.width(), reader.height(), reader.pixels(&white)};
}

GreyPixels read_grey_png(std::string_view bytes, const std::string& label) {
    PngReader reader(bytes, label, PNG_FORMAT_GA);
    const std::vector<std::uint8_t> values = reader.pixels(nullptr);
    GreyPixels result{reader.width(), reader.height(), {}};
    result.pixels.reserve(values.size() / 2);
    for (std::size_t i = 0; i + 1 < values.size(); i += 2) result.pixels.push_back({values[i], values[i + 1]});
    return result;
}

}  // namespace rinceau
