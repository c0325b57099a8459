#pragma once
// Colours as people see them: OKLab (Ottosson 2020, "A perceptual color space for image processing").

#include "geometry/point.h"
#include "scene/style.h"

namespace rinceau {

struct OklabColor {
    double lightness = 0;  ///< 0 black to 1 white
    Complex chroma;        ///< its angle is the hue, its length the colourfulness, 0 = grey
};

OklabColor to_oklab(Color color);
/// The nearest colour of sRGB, channel by channel.
Color from_oklab(const OklabColor& color);

}  // namespace rinceau
