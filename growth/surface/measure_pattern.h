#pragma once
// How well a pattern has been placed, by ways that the placing does not use: for reports, benches and tests.

#include "growth/surface/surface_pattern.h"

namespace rinceau {

struct PatternMeasureOptions {
    double touch = 0.02;           ///< share by which shapes are shrunk, as they were when placed
    int kin = 6;                   ///< ancestors that a shape may touch: against those both are halved
    double dead_band = 1e-3;       ///< share by which they are shrunk besides, so that rounding is no overlap
    long max_pairs = 100'000'000;  ///< of near shapes that are looked at
};

struct PatternMeasures {
    long overlaps = 0;       ///< pairs of shapes that overlap although the later one was tested
    long kin_touching = 0;   ///< pairs of a shape and an ancestor that overlap no more than they may
    long through_sheet = 0;  ///< pairs on both faces of a thin sheet that meet inside of it: tested are the parts above
    long pairs = 0;          ///< of shapes near enough to be looked at
    bool complete = true;    ///< false: max_pairs was reached
    /// Largest distance of a foot (where a shape stands, where a line has a point) from the surface, and of a shape's
    /// position from the normal through its foot; share of the surface's diagonal.
    double surface_distance_max = 0;
};

PatternMeasures measure_pattern(const SurfacePattern& pattern, const SurfaceMesh& surface,
                                const PatternMeasureOptions& options = {});

}  // namespace rinceau
