#pragma once
// viewBox and preserveAspectRatio (SVG 1.1, sections 7.7 and 7.8).

#include <optional>
#include <string_view>

#include "geometry/affine.h"

namespace rinceau {

/// Width and height may be 0 (nothing is drawn then) but not negative.
struct ViewBox {
    double x = 0, y = 0, width = 0, height = 0;
    friend constexpr bool operator==(const ViewBox&, const ViewBox&) = default;
};
std::optional<ViewBox> parse_view_box(std::string_view text);

/// Where the view box goes in its viewport: share of the free room before it.
struct AspectRatio {
    double align_x = 0.5, align_y = 0.5;  ///< 0 = min, 0.5 = mid, 1 = max
    bool stretch = false;                 ///< "none": both sides fit, unevenly
    bool slice = false;                   ///< cover the viewport instead of fitting into it
    friend constexpr bool operator==(const AspectRatio&, const AspectRatio&) = default;
};
std::optional<AspectRatio> parse_aspect_ratio(std::string_view text);

/// From the space of the view box (width and height > 0) to a viewport of this size at the origin; y down on both sides.
Affine view_box_map(const ViewBox& box, const AspectRatio& aspect, double width, double height);

}  // namespace rinceau
