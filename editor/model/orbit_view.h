#pragma once
// How a surface is looked at: turned about its middle, in parallel projection.

#include <optional>

#include "geometry/point.h"
#include "growth/surface/surface_point.h"

namespace rinceau {

/// Window points have y down, from the upper left corner of what the view fills.
struct OrbitView {
    SpacePoint centre;       ///< in the middle of the view
    double azimuth = 0.5;    ///< radians that the eye has gone round to its right
    double elevation = 0.4;  ///< radians above the ground, in [-pi/2, pi/2]
    double zoom = 1;         ///< pixels a unit of length
    Point size{1, 1};        ///< pixels
    bool z_up = false;       ///< z points up, else y
    friend bool operator==(const OrbitView&, const OrbitView&) = default;
};

/// Unit vectors of the view: to the right, up, towards the eye.
struct OrbitFrame {
    SpacePoint right, up, towards;
};
OrbitFrame orbit_frame(const OrbitView& view);

/// Where a place is seen, and how near to the eye it is (larger = nearer).
struct SeenPlace {
    Point at;
    double nearness = 0;
};
SeenPlace seen_at(const OrbitView& view, SpacePoint place);

/// The box of `low` and `high` in the middle, as large as fits.
OrbitView fitted_to(OrbitView view, SpacePoint low, SpacePoint high);
/// Turned as a mouse turns a ball that it drags by so many pixels.
OrbitView turned_by(OrbitView view, Point pixels);
OrbitView panned_by(OrbitView view, Point pixels);
/// The place under `at` stays there.
OrbitView zoomed_at(OrbitView view, Point at, double factor);

/// The nearest point of the surface under a window point; nothing if none is there.
std::optional<SurfacePoint> surface_point_under(const SurfaceMesh& surface, const OrbitView& view, Point at);

/// Is a point of the surface seen, not hidden behind another part of it?
bool is_seen(const SurfaceMesh& surface, const OrbitView& view, SpacePoint place);

}  // namespace rinceau
