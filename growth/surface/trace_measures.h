#pragma once
// How well walks keep their angle to a field, measured by a way that walking does not use: for reports, benches and tests.

#include <cstdint>

#include "growth/surface/trace.h"

namespace rinceau {

struct TraceMeasureOptions {
    int walks = 2000;
    double edges = 3;  ///< length of a walk, mean edges of the surface
    int rings = 2;     ///< faces so near to a face with a singular point do not count
    double limit = 2;  ///< degrees
    std::uint64_t seed = 1;
    TraceOptions trace;
};

struct TraceMeasures {
    long walks = 0;         ///< that count: clear of singular points and borders
    long pieces = 0;        ///< straight ones, that were measured
    double angle_mean = 0;  ///< radians, by length: between a piece and the walk's angle to the field in the piece's middle
    double angle_max = 0;   ///< of all pieces
    long walks_above = 0;   ///< with a piece off by more than the limit
    double length_error = 0;  ///< largest, between what was asked and the path in space; share of the length
};

/// Walks from random places in random directions.
TraceMeasures measure_traces(const FieldOnSurface& field, const TraceMeasureOptions& options = {});

/// By face: is it within so many rings of a face with a singular point? A ring is all faces that share a vertex.
std::vector<bool> near_singular_faces(const FieldOnSurface& field, int rings);

}  // namespace rinceau
