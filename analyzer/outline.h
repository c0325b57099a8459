#pragma once
// The outline of an element: the curves that its paint shows, whatever sub-paths and start points they are written with
// (the elements of Stava et al. 2010, section 4.1).

#include <vector>

#include "geometry/cubic_bezier.h"
#include "scene/element.h"

namespace rinceau {

struct OutlinePiece {
    CubicBezier curve;  ///< a straight piece has its control points on its ends
    bool straight = true;
};

/// Curves about an origin near them, so that no digits are lost where coordinates are large.
struct Outline {
    Point origin;                      ///< scene space; pieces are relative to it
    std::vector<OutlinePiece> pieces;  ///< in drawing order, none of length 0
};

/// The boundary that a fill or stroke shows. Closing lines count where they are drawn: of closed sub-paths always, of open
/// ones if the element is not stroked (a fill closes every sub-path).
Outline outline_of(const std::vector<Path>& paths, const Style& style);

/// The piece moved by -center and scaled by 1 / unit.
OutlinePiece in_frame(const OutlinePiece& piece, Point center, double unit);

}  // namespace rinceau
