#pragma once
// How an element is painted. All lengths and gradients are in the frame of the paths that the style goes with, so that a
// style can be carried along by a similarity.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "geometry/affine.h"
#include "geometry/similarity.h"

namespace rinceau {

/// sRGB, 0..255 a channel.
struct Color {
    std::uint8_t red = 0, green = 0, blue = 0;
    friend constexpr bool operator==(const Color&, const Color&) = default;
};

struct GradientStop {
    double offset = 0;  ///< 0..1, not falling along the list
    Color color;
    double opacity = 1;  ///< 0..1
    friend constexpr bool operator==(const GradientStop&, const GradientStop&) = default;
};

enum class GradientKind : std::uint8_t { linear, radial };
enum class GradientSpread : std::uint8_t { pad, reflect, repeat };

/// A gradient with at least two stops. The unit gradient is laid into the paths' frame by `map`:
/// linear: from (0,0) to (1,0), constant along y; radial: unit circle about (0,0) with focus (focus.x, focus.y), |focus| < 1,
/// and focal radius `focal_radius` in [0, 1).
struct Gradient {
    GradientKind kind = GradientKind::linear;
    GradientSpread spread = GradientSpread::pad;
    std::vector<GradientStop> stops;
    Affine map;
    Point focus{};
    double focal_radius = 0;
    friend bool operator==(const Gradient&, const Gradient&) = default;
};

struct NoPaint {
    friend constexpr bool operator==(const NoPaint&, const NoPaint&) = default;
};

/// A gradient is shared between copies and never changed in place.
using Paint = std::variant<NoPaint, Color, std::shared_ptr<const Gradient>>;

enum class FillRule : std::uint8_t { nonzero, evenodd };
enum class LineCap : std::uint8_t { butt, round, square };
enum class LineJoin : std::uint8_t { miter, round, bevel };

/// 2 x 2 linear map (x, y) -> (a x + c y, b x + d y).
struct Linear2 {
    double a = 1, b = 0, c = 0, d = 1;
    friend constexpr bool operator==(const Linear2&, const Linear2&) = default;
};

struct Stroke {
    Paint paint = NoPaint{};
    double opacity = 1;
    double width = 1;  ///< in the frame of the paths, before `pen`
    /// Width and dashes are scene lengths, whatever the frame: they do not follow the scale of a similarity. `pen` is the
    /// identity then. Never set in the elements of a scene, whose frame is the scene's.
    bool fixed = false;
    LineCap cap = LineCap::butt;
    LineJoin join = LineJoin::miter;
    double miter_limit = 4;
    std::vector<double> dashes;  ///< even count, empty = solid
    double dash_offset = 0;
    /// The pen is this image of the circle of diameter `width`: identity unless the drawing sheared or stretched the
    /// stroke. Dashes are measured before it.
    Linear2 pen;
};

struct Style {
    Paint fill = Color{};
    double fill_opacity = 1;
    FillRule fill_rule = FillRule::nonzero;
    Stroke stroke;
    double opacity = 1;           ///< of fill and stroke together
    bool stroke_first = false;    ///< paint-order: stroke before fill
    bool crisp_edges = false;     ///< shape-rendering: crispEdges or optimizeSpeed
};

bool paints_fill(const Style& style);
bool paints_stroke(const Style& style);

/// The style of the paths' image under `map`: gradient maps, stroke widths, dashes and pens follow; of a fixed stroke only
/// the paint.
Style transformed(const Style& style, const Similarity& map);

/// Same picture? Compares what is painted only (a stroke without paint has no width), numbers within `tolerance`
/// relative to the frame's unit length, those of pens and dashes also to rounding (opacities and offsets within 1/512),
/// colours exactly. In this frame: whether a stroke is fixed does not count.
bool same_style(const Style& a, const Style& b, double tolerance);

/// Is a line drawn equally wide by both in every direction, but for `tolerance` (unit lengths) and rounding?
bool same_pen(const Stroke& a, const Stroke& b, double tolerance);

}  // namespace rinceau
