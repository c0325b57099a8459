#include "scene/element.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/pen.h"

namespace rinceau {

namespace {

bool has_joins(const Path& path) { return path.segments.size() + (path.closed ? 1 : 0) > 1; }

// How far a stroke reaches from the outline, in half widths.
double reach(const std::vector<Path>& paths, const Stroke& stroke) {
    const bool mitres = stroke.join == LineJoin::miter && std::any_of(paths.begin(), paths.end(), has_joins);
    const double half_widths = stroke.cap == LineCap::square ? std::numbers::sqrt2 : 1;
    return mitres ? std::max(half_widths, stroke.miter_limit) : half_widths;
}

}  // namespace

Box painted_box(const Element& element) {
    if (!element.verbatim.empty()) return element.verbatim_box;
    const Box outline = bounds(element.paths);
    if (!paints_stroke(element.style)) return outline;
    const Stroke& stroke = element.style.stroke;
    return grown(outline, 0.5 * stroke.width * largest_stretch(stroke.pen) * reach(element.paths, stroke));
}

double drawing_diagonal(const Scene& scene) {
    double length = diagonal(scene.viewport);
    if (!(length > 0)) {
        Box box;
        for (const Element& element : scene.elements) box = including(box, painted_box(element));
        length = diagonal(box);
    }
    return length > 0 ? length : 1;
}

}  // namespace rinceau
