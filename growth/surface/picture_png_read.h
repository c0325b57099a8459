#pragma once
// Pictures from PNG files.

#include <string>
#include <string_view>

#include "scene/picture.h"

namespace rinceau {

/// Any colour type, 8 or 16 bits, over white. Throws InputError in the name of `label` if the bytes are no PNG, LimitError
/// for more than 16 million pixels.
Picture read_picture_png(std::string_view bytes, const std::string& label);

}  // namespace rinceau
