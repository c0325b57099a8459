#pragma once
// A shape grammar's derivation on a surface (Li et al. 2010, sections 3.2, 4.3 and 4.4).

#include <cstdint>

#include "geometry/progress.h"
#include "growth/surface/shape_grammar.h"
#include "growth/surface/surface_pattern.h"
#include "growth/surface/surface_world.h"
#include "growth/surface/trace.h"

namespace rinceau {

enum class CullScope : unsigned char { bracket, rule, none };

struct ShapeDerivationOptions {
    std::uint64_t seed = 1;
    long max_shapes = 1'000'000;  ///< placed and waiting, together; more ends the derivation
    long max_rules = 20'000'000;  ///< applied; more ends it
    double max_seconds = 0;       ///< 0 = none
    int steps = -1;               ///< rules to apply, for deriving step by step; -1 = all
    bool breadth_first = true;
    CullScope cull = CullScope::bracket;
    bool collide_all = false;  ///< every I is an IC (section 4.4.1's global flag)
    double touch = 0.02;
    int kin = 6;  ///< ancestors that a shape may touch
    TraceOptions trace;
};

/// Grows all axioms. Options of the grammar (option name = value) have been taken over before, see options_of(). Throws
/// InputError, with rule and line, for sizes that are not positive, numbers that are not finite, unknown symbols, shapes and
/// fields. A bound that is reached leaves the pattern with complete = false.
SurfacePattern derive_shapes(const ShapeGrammar& grammar, const SurfaceWorld& world,
                             const ShapeDerivationOptions& options = {}, const Progress& progress = {});

/// The defaults with what the grammar's options say.
ShapeDerivationOptions options_of(const ShapeGrammar& grammar, ShapeDerivationOptions defaults = {});

}  // namespace rinceau
