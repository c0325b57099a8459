#pragma once
// What has grown on a surface, in figures, for programs to read (docs/grow_report.schema.json).

#include <string>
#include <vector>

#include "growth/surface/grow_drawing.h"
#include "growth/surface/surface_field.h"
#include "growth/surface/surface_pattern.h"

namespace rinceau {

/// Wall time.
struct GrowSeconds {
    double input = 0;   ///< reading the grammar; of a drawing, finding its rules
    double ground = 0;  ///< the surface, its fields and the shapes
    double growth = 0;
    double output = 0;
    double total = 0;
};

struct GrowReport {
    std::string input, surface;  ///< names as given; no surface: the plane
    const SurfacePattern* pattern = nullptr;
    const SurfaceMesh* ground = nullptr;
    const FieldOnSurface* field = nullptr;  ///< that guides; may be none
    const GrownDrawing* drawing = nullptr;  ///< what was laid; none of a shape grammar
    std::uint64_t seed = 1;
    long faces = 0;  ///< that are written
    std::vector<std::string> warnings;
    GrowSeconds seconds;
};

/// As JSON text, two blanks a level, a line end at its end. Measures overlaps and distances afresh.
std::string grow_report_json(const GrowReport& report);

}  // namespace rinceau
