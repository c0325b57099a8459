#pragma once
// Which rotation, or mirror image and rotation, lays one outline onto another, judged by their moments (docs/analysis.md,
// 1).

#include <vector>

#include "analyzer/moments.h"
#include "geometry/similarity.h"

namespace rinceau {

/// z -> exp(i angle) * (mirrored ? conj(z) : z), from the unit frame of one outline to that of the other.
struct Alignment {
    double angle = 0;
    bool mirrored = false;
    double residual = 0;  ///< weighted root sum of squares of the moments' differences; 0 for exact copies
};

/// The local best alignments of `from` onto `to` with a residual of at most `max_residual`, best first, at most `count`.
std::vector<Alignment> alignments(const Moments& from, const Moments& to, bool mirrored, double max_residual,
                                  std::size_t count);

/// Residual of one rotation, or mirror image and rotation.
double alignment_residual(const Moments& from, const Moments& to, double angle, bool mirrored);

inline Similarity to_similarity(const Alignment& alignment) { return {polar(1, alignment.angle), {}, alignment.mirrored}; }

}  // namespace rinceau
