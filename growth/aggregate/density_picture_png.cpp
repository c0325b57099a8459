// Grey and opacity in 256 steps whatever the file holds, which is as fine as a density can be told.

#include "growth/aggregate/density_picture_png.h"

#include "growth/picture_png_read.h"

namespace rinceau {

DensityPicture read_density_png(std::string_view bytes, const Box& box, const std::string& label) {
    const GreyPixels grey = read_grey_png(bytes, label);
    DensityPicture picture{grey.width, grey.height, {}, box};
    picture.values.reserve(grey.pixels.size());
    constexpr double full = 255;
    for (const GreyPixels::Pixel& pixel : grey.pixels)
        picture.values.push_back(pixel.opacity / full * (1 - pixel.grey / full));  // over white
    return picture;
}

}  // namespace rinceau
