#pragma once
// A picture that lies in the plane: its colours and the ways of its edges, anywhere.

#include <array>
#include <string>
#include <vector>

#include "geometry/box.h"
#include "scene/picture.h"

namespace rinceau {

struct PlanePicture {
    Picture pixels;
    /// By pixel, as pixels.rgb is ordered: strength * exp(2 i angle) of the way along the picture's edges there, from +x
    /// counter-clockwise; strength 1 at most. Never 0 unless the whole picture is flat.
    std::vector<Complex> along;
    Box box;  ///< of the plane that it covers; y is up
};

/// Between the middles of four pixels linear; beyond the box what its rim has.
Complex edges_along(const PlanePicture& picture, Point place);
/// Red, green, blue in [0, 255].
std::array<double, 3> colour_at(const PlanePicture& picture, Point place);
/// In [0, 1]; white is 1.
double brightness_at(const PlanePicture& picture, Point place);
/// The side of a pixel in the plane.
double pixel_side(const PlanePicture& picture);

struct PictureEdges {
    double blur = 1;   ///< pixels, standard deviation: of the picture before it is differentiated; 0 = none
    double sigma = 4;  ///< pixels: of the edges' own tensors, averaged; more is steadier against noise
};

/// The picture as large as fits into the box, in its middle. Throws InputError in the name of `label` if it has no pixel or
/// a width is negative or above 200.
PlanePicture plane_picture(Picture picture, const Box& box, const PictureEdges& edges, const std::string& label);

}  // namespace rinceau
