#pragma once
// The area that an element keeps for itself: no two of them overlap (Sakurai & Miyata 2014, section 3.1).

#include <string>
#include <vector>

#include "geometry/point.h"
#include "growth/figures.h"
#include "scene/painted_region.h"

namespace rinceau {

struct InnerDisc {
    Point center;
    double radius = 0;
};

/// In the shape's own frame: the origin is the centre of the region's box (section 3.1, eq. 1).
struct ExclusiveRegion {
    std::vector<std::vector<Point>>
        rings;                     ///< simple, apart; the first is the outer one, counter-clockwise; others are holes
    Point center;                  ///< the origin in the figure's frame
    double radius = 0;             ///< R: of the circle about the origin that holds it (section 4.1, figure 9)
    std::vector<InnerDisc> discs;  ///< inside the region, largest first: together they nearly fill it
    double area = 0;               ///< holes taken off
};

struct ExclusiveRegionOptions {
    double margin = 0;              ///< scene length that is added outward all around, or taken away if negative
    bool keep_holes = false;        ///< others may stand in the holes of a shape
    double closing = 0.03;          ///< slots narrower than twice this share of the diagonal are closed
    double simplification = 0.003;  ///< largest distance of the region from the outline, as a share of the diagonal
};

/// The figure's outline lies inside the region if the margin is not negative. Throws InputError in the name of `label` if
/// the outline has no area or the margin leaves none.
ExclusiveRegion exclusive_region(const Region& outline, const ExclusiveRegionOptions& options, const std::string& label);

/// The same from a region that a user has drawn (section 3.1), without closing.
ExclusiveRegion drawn_exclusive_region(const Region& region, const ExclusiveRegionOptions& options,
                                       const std::string& label);

}  // namespace rinceau
