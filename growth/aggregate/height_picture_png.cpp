#include "growth/aggregate/height_picture_png.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstdint>

#include "geometry/index.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

constexpr int bits = 16;
constexpr double top = 65535;

void append_bytes(png_structp png, png_bytep bytes, std::size_t count) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

void flush_nothing(png_structp) {}

/// False if libpng gives up; it does so by a jump, over which nothing may stand that has to be destroyed.
bool write_rows(png_structp png, png_infop info, const HeightMap& map, png_bytep row_bytes) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_IHDR(png, info, static_cast<png_uint_32>(map.columns), static_cast<png_uint_32>(map.rows), bits,
                 PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            const std::size_t i =
                static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns) + static_cast<std::size_t>(column);
            const auto value = static_cast<std::uint16_t>(std::lround(top * std::clamp(map.heights[i], 0.0, 1.0)));
            row_bytes[2 * at(column)] = static_cast<png_byte>(value >> 8U);  // high byte first
            row_bytes[2 * at(column) + 1] = static_cast<png_byte>(value & 0xFFU);
        }
        png_write_row(png, row_bytes);
    }
    png_write_end(png, info);
    return true;
}

}  // namespace

std::string height_png(const HeightMap& map) {
    std::string bytes;
    std::vector<png_byte> row(2 * static_cast<std::size_t>(map.columns));
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
    bool done = false;
    if (info != nullptr) {
        png_set_write_fn(png, &bytes, append_bytes, flush_nothing);
        done = write_rows(png, info, map, row.data());
    }
    png_destroy_write_struct(&png, &info);
    if (!done) throw LimitError({}, "the height map could not be made a PNG picture");
    return bytes;
}

}  // namespace rinceau
