#pragma once
// A field drawn as evenly spaced lines over a whole surface.

#include <vector>

#include "geometry/progress.h"
#include "growth/surface/trace.h"

namespace rinceau {

struct StreamlineOptions {
    double spacing = 0;            ///< between neighbouring lines, surface length; 0 = a 64th of the surface's diagonal
    double nearest = 0.5;          ///< of the spacing: a line ends that comes so near to another
    double shortest = 2;           ///< of the spacing: shorter lines are left out, unless they are closed
    bool major = true;             ///< along the field; of crosses both are drawn in any case
    bool minor = false;            ///< across it
    long max_samples = 1'000'000;  ///< four for each spacing of a line; more end the drawing
};

struct Streamline {
    std::vector<SurfacePoint> path;  ///< as SurfaceTrace::path; of a closed line the first is also the last
    bool closed = false;
    bool minor = false;
};

struct Streamlines {
    std::vector<Streamline> lines;
    double spacing = 0;
    bool complete = true;  ///< false: max_samples was reached
};

/// Jobard & Lefer 1997, "Creating evenly-spaced streamlines of arbitrary density", on a surface: new lines begin a spacing
/// beside known ones, then wherever a face is still empty. Nearness is measured in space between lines that run alike on
/// sheets that face alike. Lines of a symmetric tensor field follow eigenvectors, of crosses all four directions. The same
/// for the same input.
Streamlines streamlines(const FieldOnSurface& field, const StreamlineOptions& options = {}, const Progress& progress = {});

}  // namespace rinceau
