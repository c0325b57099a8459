#include "exports/palette.h"

#include <algorithm>

namespace rinceau {

namespace {

int distance(Color a, Color b) {
    const int red = a.red - b.red;
    const int green = a.green - b.green;
    const int blue = a.blue - b.blue;
    return red * red + green * green + blue * blue;
}

}  // namespace

int Palette::number_of(Color color) {
    auto found = std::ranges::find(colors_, color);
    if (found == colors_.end() && static_cast<int>(colors_.size()) <= last_ - first_) {
        colors_.push_back(color);
        found = colors_.end() - 1;
    }
    if (found == colors_.end()) {
        overflowed_ = true;
        found = std::ranges::min_element(colors_, {}, [&](Color known) { return distance(known, color); });
    }
    return first_ + static_cast<int>(found - colors_.begin());
}

}  // namespace rinceau
