#pragma once
// How the two parts of a look are painted, in the order in which they lie.

#include <array>
#include <cstdint>
#include <memory>

#include "scene/style.h"

namespace rinceau {

enum class LookPart : std::uint8_t { fill, stroke };
constexpr std::size_t index_of(LookPart part) { return static_cast<std::size_t>(part); }

/// Red, green, blue, not multiplied by opacity, and opacity.
using PackedColor = std::array<std::uint8_t, 4>;

struct PartPaint {
    bool painted = false;
    Color color;                               ///< white if `gradient` is set
    double opacity = 1;                        ///< of this part alone
    std::shared_ptr<const Gradient> gradient;  ///< null = solid
    bool opaque = false;                       ///< nothing below shines through
};

struct LookPaint {
    std::array<PartPaint, 2> parts;  ///< by LookPart
    double opacity = 1;              ///< of both together
    LookPart upper = LookPart::stroke;
    bool crisp = false;   ///< edges are not smoothed
    bool opaque = false;  ///< of both parts: what lies below an instance is hidden by it
    /// Both parts are faded together, and the upper one lets the lower one through: no order of drawing alone does that.
    bool mixes_within = false;

    LookPart lower() const { return upper == LookPart::fill ? LookPart::stroke : LookPart::fill; }
    const PartPaint& part(LookPart which) const { return parts[index_of(which)]; }
};

LookPaint look_paint(const Style& style);

/// Colour and opacity that a solid part, or the opacity that a gradient part is multiplied by, under the whole's opacity.
PackedColor packed_color(const Color& color, double opacity);

}  // namespace rinceau
