#pragma once
// What part of the scene the canvas shows.

#include "geometry/box.h"
#include "geometry/point.h"

namespace rinceau {

/// Scene (y up) -> canvas in framebuffer pixels, y down, origin at the canvas's upper left corner.
struct ViewTransform {
    Point center{};    ///< scene point in the middle of the canvas
    double zoom = 1;   ///< framebuffer pixels per scene unit, > 0
    Point size{1, 1};  ///< of the canvas, framebuffer pixels

    friend constexpr bool operator==(const ViewTransform&, const ViewTransform&) = default;
};

constexpr Point to_canvas(const ViewTransform& view, Point scene) {
    return {0.5 * view.size.x + (scene.x - view.center.x) * view.zoom,
            0.5 * view.size.y - (scene.y - view.center.y) * view.zoom};
}
constexpr Point to_scene_point(const ViewTransform& view, Point canvas) {
    return {view.center.x + (canvas.x - 0.5 * view.size.x) / view.zoom,
            view.center.y - (canvas.y - 0.5 * view.size.y) / view.zoom};
}

/// The view of the same size in which all of `box` is seen with a small margin; the view as it is for an empty box.
ViewTransform fitted_view(const ViewTransform& view, const Box& box);

/// Zoomed by `factor`, the scene point under `canvas` staying where it is. The zoom stays within reason.
ViewTransform zoomed_view(const ViewTransform& view, Point canvas, double factor);

/// Moved with the mouse by so many framebuffer pixels.
ViewTransform panned_view(const ViewTransform& view, Point by);

}  // namespace rinceau
