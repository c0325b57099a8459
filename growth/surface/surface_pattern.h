#pragma once
// What a grammar has grown on a surface: a value, for outputs, pictures, reports and tests.

#include <map>
#include <string>
#include <vector>

#include "growth/mesh/triangle_mesh.h"
#include "growth/surface/grammar_shape.h"
#include "growth/surface/surface_point.h"

namespace rinceau {

/// A terminal shape in its scope (Li et al. 2010, section 3.1).
struct PatternShape {
    int shape = 0;                   ///< index into SurfacePattern::shapes
    SpacePoint position;             ///< of the scope: the surface point moved along the normal by the sum of all t_z
    std::array<SpacePoint, 3> axes;  ///< of length 1, right-handed
    SpacePoint size{1, 1, 1};        ///< positive
    SurfacePoint at;                 ///< the surface point below it
    Color color{204, 204, 204};
    int rule = -1;        ///< that placed it, index into the grammar's rules; -1 = an axiom
    int depth = 0;        ///< of the derivation
    bool tested = false;  ///< placed by IC or in a Lock: free of overlap with all that was placed before it
    int parent = -1;      ///< the placed shape before it on its path, which it may touch; -1 = none
    int set = -1;         ///< number of the Lock that it came with, whose parts may overlap each other; -1 = none
    std::map<std::string, double> attributes;
};

/// Pieces that follow each other; a merged line ends on the line that it met.
struct PatternLine {
    std::vector<SpacePoint> points;   ///< on the surface, where pieces meet and where they bend
    std::vector<SpacePoint> normals;  ///< of the surface there
    std::vector<double> widths;       ///< there
    std::vector<SurfacePoint> at;
    Color color{204, 204, 204};
    bool merged = false;  ///< its end was cut at another line
    int segments = 0;     ///< LineSeg commands
};

struct PatternCounts {
    long translations = 0;
    long collisions_avoided = 0;  ///< shapes not placed because they would overlap
    long merged_points = 0;       ///< IM that found its twin
    long merged_lines = 0;
    long borders_met = 0;
    long locks_given_up = 0;
    long rules_applied = 0;
    double angle_error_max = 0;  ///< radians, of all translations along fields
    double angle_error_sum = 0;
    long angle_samples = 0;
    long jumps = 0;  ///< over singular points
};

/// Many copies of few shapes, lines, and what was laid out as triangles of its own.
struct SurfacePattern {
    std::vector<GrammarShape> shapes;
    std::vector<PatternShape> placed;
    std::vector<PatternLine> lines;
    std::vector<NamedMesh> laid;  ///< a drawing's outlines on the surface, one mesh for each colour and layer
    PatternCounts counts;
    bool complete = true;  ///< false: a bound was reached; what stands is what grew before
    std::string limit;     ///< which bound, and the cure
    std::vector<std::string> warnings;
};

struct AssemblyOptions {
    bool with_surface = false;  ///< the ground itself as a first mesh
    Color surface_color{225, 222, 214};
    int line_sides = 6;  ///< of the tubes that lines become
};

/// Everything as meshes and their instances: one mesh for each shape and colour.
MeshAssembly assembly_of(const SurfacePattern& pattern, const SurfaceMesh& surface, const AssemblyOptions& options = {});
/// Triangles of all instances.
long faces_out(const MeshAssembly& assembly);

}  // namespace rinceau
