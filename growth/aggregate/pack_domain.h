#pragma once
// Where an aggregate is laid out.

#include <optional>
#include <vector>

#include "geometry/box.h"
#include "scene/painted_region.h"

namespace rinceau {

struct PackDomain {
    Box box;                        ///< of the whole
    std::optional<Region> region;   ///< exclusive regions lie inside it; none = the box
    bool tiled = false;             ///< what leaves the box on one side comes in on the other: a tile without a seam
};

/// Grey values over the domain: how much is to stand there, 0 (nothing) to 1.
struct DensityPicture {
    int columns = 0, rows = 0;
    std::vector<double> values;  ///< row by row from the top
    Box box;                     ///< that it is stretched over
};

/// The value at p, between pixels bilinear; outside of the box that of its edge. The picture has a pixel and the box an area.
double density_at(const DensityPicture& picture, Point p);

}  // namespace rinceau
