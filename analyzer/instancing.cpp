// Stava et al. 2010, section 4.2. A similarity group of the paper is a look here: shape and style together. Deviation: the
// paper leaves mirror images apart; here a mirror is part of every pose.
#include "analyzer/instancing.h"

#include "analyzer/match_elements.h"
#include "analyzer/match_styles.h"

namespace rinceau {

namespace {

/// Paths of the look in its unit frame: the class representative's, unless its sub-paths would be painted otherwise; a dot
/// is a line without length.
std::vector<Path> unit_paths(const Scene& scene, const ShapeMatching& shapes, const StyleMatching& styles,
                             const StyledLook& look) {
    constexpr double same_start = 1e-3;  // unit lengths: a start point that may be moved unseen
    const ShapeClass& shape = shapes.classes[static_cast<std::size_t>(look.shape)];
    const int representative = shape.representative;
    const Similarity& pose = shapes.matches[static_cast<std::size_t>(representative)].pose;
    if (shape.dots) return {Path{.segments = {line_to({})}}};
    Element candidate{scene.elements[static_cast<std::size_t>(representative)].paths, transformed(look.unit_style, pose)};
    const PaintedForm form = painted_form(candidate, pose);
    if (same_form(form, look.form) && same_starts(form, Similarity{}, look.form, same_start))
        return transformed(candidate.paths, inverse(pose));
    // A look of its own sub-paths: as first drawn.
    const std::size_t first = static_cast<std::size_t>(look.first);
    return transformed(scene.elements[first].paths, inverse(styles.instances[first].pose));
}

}  // namespace

Instancing group_similar_elements(const Scene& scene, const SimilarityOptions& options, const Progress& progress) {
    // Classes of equal outline, each with its symmetries.
    const ShapeMatching shapes = match_elements(scene, options, progress);
    // Classes of equal outline and style.
    StyleMatching styles = match_styles(scene, shapes);
    // Looks in their unit frames.
    Instancing result;
    result.shapes = static_cast<int>(shapes.classes.size());
    result.styles = styles.styles;
    for (StyledLook& found : styles.looks) {
        Look look;
        look.style = found.style;
        look.symmetry = std::move(found.symmetry);
        if (found.shape < 0) {
            look.shape = result.shapes++;
            look.verbatim = scene.elements[static_cast<std::size_t>(found.first)].verbatim;
        } else {
            look.shape = found.shape;
            look.paths = unit_paths(scene, shapes, styles, found);
            look.unit_style = std::move(found.unit_style);
        }
        result.looks.push_back(std::move(look));
    }
    result.instances = std::move(styles.instances);
    report(progress, "similarity", 1);
    return result;
}

}  // namespace rinceau
