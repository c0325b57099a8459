// Density pictures between their pixels.

#include "growth/aggregate/pack_domain.h"

#include <algorithm>
#include <cmath>

namespace rinceau {

double density_at(const DensityPicture& picture, Point p) {
    // Values stand at the middle of their pixels.
    const auto along = [](double share, int count) { return std::clamp(share * count - 0.5, 0.0, count - 1.0); };
    const double x = along((p.x - picture.box.low.x) / width(picture.box), picture.columns);
    const double y = along((picture.box.high.y - p.y) / height(picture.box), picture.rows);
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    const auto value = [&picture](int c, int r) {
        const int column_index = std::min(c, picture.columns - 1), row_index = std::min(r, picture.rows - 1);
        return picture.values[static_cast<std::size_t>(row_index) * static_cast<std::size_t>(picture.columns) +
                              static_cast<std::size_t>(column_index)];
    };
    const auto between = [&](int r) { return std::lerp(value(column, r), value(column + 1, r), x - column); };
    return std::lerp(between(row), between(row + 1), y - row);
}

}  // namespace rinceau
