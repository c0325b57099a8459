#pragma once
// What the paint tells of an outline beyond its curves: which regions a fill covers, where a stroke has ends, and where
// dashes begin. Elements of equal outline share a look only if these agree too.

#include <vector>

#include "geometry/similarity.h"
#include "scene/element.h"

namespace rinceau {

/// Where a sub-path begins and which way it leaves.
struct PathStart {
    Point at;
    Point direction;  ///< length 1, or 0 for a sub-path without length
    bool closed = false;
};

/// In the unit frame of the element's pose.
struct PaintedForm {
    double covered_area = 0;  ///< sum of the sub-paths' areas without sign; 0 if there is no fill
    double wound_area = 0;    ///< |sum of their signed areas| for the nonzero rule; 0 for evenodd
    int sub_paths = 0;        ///< number of sub-paths that a stroke draws; 0 if there is no stroke
    int open_paths = 0;       ///< of them, how many have ends
    /// Not empty: the stroke is dashed, or an open sub-path ends where it starts, so that start and direction show.
    std::vector<PathStart> starts;
};

PaintedForm painted_form(const Element& element, const Similarity& pose);

/// Do the starts of `a` under `map` lie within `distance` on those of `b`, in order and direction?
bool same_starts(const PaintedForm& a, const Similarity& map, const PaintedForm& b, double distance);

/// All but the starts.
bool same_form(const PaintedForm& a, const PaintedForm& b);

}  // namespace rinceau
