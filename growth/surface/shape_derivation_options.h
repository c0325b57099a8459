#pragma once
// How a shape grammar derives, and how far.

#include <cstdint>
#include <string>

#include "growth/surface/shape_grammar.h"
#include "growth/surface/trace.h"

namespace rinceau {

/// What a collision, a merged shape, the end of a line or the surface's border culls: the rest of the command string inside
/// its bracket; the rest of the production (the literal reading of Li et al. 2010, section 4.4.1); or nothing but the shape.
/// Where a way ends, at a border or a line that is met, at least the bracket is culled.
enum class CullScope : unsigned char { bracket, rule, none };

struct ShapeDerivationOptions {
    std::uint64_t seed = 1;
    long max_shapes = 1'000'000;  ///< placed and waiting, and points of lines, together; more ends the derivation
    long max_rules = 20'000'000;  ///< applied; more ends it
    double max_seconds = 0;       ///< 0 = none
    int steps = -1;               ///< rules to apply, for deriving step by step; -1 = all
    bool breadth_first = true;
    CullScope cull = CullScope::bracket;
    bool collide_all = false;  ///< every I and IM is tested as IC is (section 4.4.1's global flag)
    double touch = 0.02;
    int kin = 6;         ///< ancestors that a shape may touch
    std::string follow;  ///< the field that guides translations; empty = the first one, none = straight ways
    TraceOptions trace;
};

/// The defaults with what the grammar's options say: cull = bracket | rule | none, order = breadth | depth, collide = all |
/// asked, follow = F2 | none, and the numbers touch, kin, step, turn, jump, follow_share, max_shapes, max_rules,
/// max_seconds. Others are not looked at. Throws InputError for values that cannot be.
ShapeDerivationOptions options_of(const ShapeGrammar& grammar, ShapeDerivationOptions defaults = {});

}  // namespace rinceau
