#include "editor/gl/look_paint.h"

#include <algorithm>
#include <cmath>

namespace rinceau {
namespace {

constexpr double full = 255;

bool is_opaque(double opacity) { return std::lround(full * opacity) >= std::lround(full); }

PartPaint part_paint(const Paint& paint, double opacity, bool painted) {
    PartPaint part;
    part.painted = painted;
    part.opacity = std::clamp(opacity, 0.0, 1.0);
    part.opaque = is_opaque(part.opacity);
    if (const auto* color = std::get_if<Color>(&paint)) part.color = *color;
    if (const auto* gradient = std::get_if<std::shared_ptr<const Gradient>>(&paint)) {
        part.color = {255, 255, 255};
        part.gradient = *gradient;
        for (const GradientStop& stop : part.gradient->stops) part.opaque = part.opaque && is_opaque(stop.opacity);
        // a cone leaves places without paint
        const bool cone =
            part.gradient->kind == GradientKind::radial && abs(part.gradient->focus) + part.gradient->focal_radius >= 1;
        part.opaque = part.opaque && !cone;
    }
    return part;
}

}  // namespace

LookPaint look_paint(const Style& style) {
    LookPaint paint;
    paint.parts[index_of(LookPart::fill)] = part_paint(style.fill, style.fill_opacity, paints_fill(style));
    paint.parts[index_of(LookPart::stroke)] = part_paint(style.stroke.paint, style.stroke.opacity, paints_stroke(style));
    paint.opacity = std::clamp(style.opacity, 0.0, 1.0);
    paint.upper = style.stroke_first ? LookPart::fill : LookPart::stroke;
    paint.crisp = style.crisp_edges;
    paint.opaque = is_opaque(paint.opacity);
    for (const PartPaint& part : paint.parts) paint.opaque = paint.opaque && (!part.painted || part.opaque);
    const bool both = paint.parts[0].painted && paint.parts[1].painted;
    paint.mixes_within = both && !is_opaque(paint.opacity) && !paint.part(paint.upper).opaque;
    return paint;
}

PackedColor packed_color(const Color& color, double opacity) {
    return {color.red, color.green, color.blue,
            static_cast<std::uint8_t>(std::lround(full * std::clamp(opacity, 0.0, 1.0)))};
}

}  // namespace rinceau
