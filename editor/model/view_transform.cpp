#include "editor/model/view_transform.h"

#include <algorithm>
#include <cmath>

namespace rinceau {
namespace {

constexpr double least_zoom = 1e-6;
constexpr double greatest_zoom = 1e6;
constexpr double fitted_share = 0.94;  ///< of the canvas that a fitted box takes

double bounded(double zoom) { return std::clamp(zoom, least_zoom, greatest_zoom); }

}  // namespace

ViewTransform fitted_view(const ViewTransform& view, const Box& box) {
    if (is_empty(box)) return view;
    ViewTransform fitted = view;
    fitted.center = center(box);
    const double across = width(box) > 0 ? view.size.x / width(box) : greatest_zoom;
    const double upright = height(box) > 0 ? view.size.y / height(box) : greatest_zoom;
    const bool point = width(box) <= 0 && height(box) <= 0;
    fitted.zoom = point ? 1 : bounded(fitted_share * std::min(across, upright));
    // the upper left corner comes to a whole pixel: edges along the picture's own are as crisp as in a browser
    const Point corner = to_canvas(fitted, {box.low.x, box.high.y});
    const Point off{corner.x - std::round(corner.x), corner.y - std::round(corner.y)};
    fitted.center = {fitted.center.x + off.x / fitted.zoom, fitted.center.y - off.y / fitted.zoom};
    return fitted;
}

ViewTransform zoomed_view(const ViewTransform& view, Point canvas, double factor) {
    const Point fixed = to_scene_point(view, canvas);
    ViewTransform zoomed = view;
    zoomed.zoom = bounded(view.zoom * factor);
    const Point now = to_scene_point(zoomed, canvas);
    zoomed.center = zoomed.center + (fixed - now);
    return zoomed;
}

ViewTransform panned_view(const ViewTransform& view, Point by) {
    ViewTransform panned = view;
    panned.center = {view.center.x - by.x / view.zoom, view.center.y + by.y / view.zoom};
    return panned;
}

}  // namespace rinceau
