#pragma once
// Density pictures from PNG files.

#include <string>
#include <string_view>

#include "growth/aggregate/pack_domain.h"

namespace rinceau {

/// The darkness of a picture: black is 1, white and transparent are 0. Any colour type, 8 or 16 bits, over white; stretched
/// over the box. Throws InputError in the name of `label` if the bytes are no PNG, LimitError for more than 16 million
/// pixels.
DensityPicture read_density_png(std::string_view bytes, const Box& box, const std::string& label);

}  // namespace rinceau
