#pragma once
// Steps between items, made independent of the arbitrary choice among symmetry-equivalent poses (docs/analysis.md, 4).

#include "analyzer/rule_model.h"

namespace rinceau {

/// The step from `from` to `to` in the frame of `from`: inverse(from) * to.
Similarity step_between(const Similarity& from, const Similarity& to);

/// One representative of all s * step * t, s in the symmetry of `from`, t in that of `to`: the same for equivalent steps,
/// and stable against rounding for steps in natural directions (0, 30, 45, 60, 90 degrees). If `from` or `to` is continuous
/// its angle is dropped (linear part real and positive, unmirrored); a continuous `from` must have step.translation = 0.
Similarity canonical_step(const Part& from, const Part& to, const Similarity& step, double still);

}  // namespace rinceau
