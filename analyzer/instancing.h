#pragma once
// Inverse instancing (Stava et al. 2010, section 4.2): the drawing as looks and poses.

#include <vector>

#include "geometry/progress.h"
#include "geometry/similarity.h"
#include "scene/element.h"

namespace rinceau {

/// The isometries that map a shape, centred at the origin, onto itself.
struct SymmetryGroup {
    std::vector<Similarity> elements{Similarity{}};  ///< translation 0, |linear| = 1; first = identity
    bool continuous = false;  ///< every rotation and mirror (circle, dot): `elements` then holds the identity only
};

/// A shape in a style: what one terminal symbol stands for. Two looks may share a shape.
struct Look {
    int shape = 0;            ///< equal for looks of equal outline
    int style = 0;            ///< equal for looks of equal style in their own frame
    SymmetryGroup symmetry;   ///< of shape and style together
    std::vector<Path> paths;  ///< unit frame: centroid of the outline at the origin, rms radius 1 (see unit_radius)
    Style unit_style;         ///< in the unit frame; lengths of a fixed stroke in the scene
    std::vector<Style> tints; ///< not empty: instances differ in style (Instance::tint); unit_style is the commonest of these
    std::string verbatim;     ///< not empty: kept as it is; never part of a rule
};

/// One element of the scene, seen as a copy of a look.
struct Instance {
    int look = 0;
    Similarity pose;  ///< unit frame -> scene. |linear| = the rms radius of the element
    int tint = 0;     ///< index into the look's tints, if it has any
};

/// instances[i] belongs to scene.elements[i].
struct Instancing {
    std::vector<Look> looks;          ///< in order of first appearance
    std::vector<Instance> instances;  ///< in paint order
    int shapes = 0;                   ///< number of different shapes
    int styles = 0;                   ///< number of different styles
};

struct SimilarityOptions {
    /// Largest distance of two outlines that count as equal, in rms radii. (Exact copies with rounded coordinates and
    /// hand-made near-copies pass 0.01; tolerance_of_diagonal keeps what is drawn within a tenth of a pixel.)
    double tolerance = 0.01;
    /// ... and in scene lengths, as a share of the drawing's diagonal, so that large elements are drawn to the pixel.
    double tolerance_of_diagonal = 2e-4;
    bool mirrored_copies = true;  ///< a mirror image is the same shape
    int threads = 0;              ///< 0 = one per processor; the result is the same for any number
};

/// Groups the elements by outline and style whatever their place, angle, size, mirror image, start point, direction,
/// order of sub-paths and splitting of segments. Every element's outline is within the tolerance of its look's outline
/// under its pose (checked both ways), and its style is the look's style carried by the pose.
Instancing group_similar_elements(const Scene& scene, const SimilarityOptions& options = {}, const Progress& progress = {});

}  // namespace rinceau
