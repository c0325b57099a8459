#pragma once
// Stochastic mode: instead of exact exceptions the rules get the noise that the drawing shows, so that every seed draws a
// relative of it (docs/analysis.md, 4.8).

#include "analyzer/instancing.h"
#include "analyzer/residuals.h"
#include "analyzer/to_grammar.h"

namespace rinceau {

/// The grammar with f(normal(m, s)), turns and scales before each module of a production whose copies, four at least, miss
/// their places by more than `tolerance` (a scene length) more often than not: m and s as the copies in the drawing have
/// them. Groups that move as one do so in the grammar, too: what a group moves by is taken out of its members. What misses
/// its place otherwise gets an exception as in with_residuals. Sets the seed if there is noise.
Residuals with_scatter(const WrittenGrammar& written, const Instancing& instancing, double tolerance);

}  // namespace rinceau
