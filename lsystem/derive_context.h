#pragma once
// Derivation with contexts: all symbols of a string are rewritten at once, step after step, because what a production does
// depends on what stands beside it. Internal to the folder.

#include <cstddef>
#include <vector>

#include "lsystem/compile.h"
#include "lsystem/derivation_limits.h"

namespace rinceau {

/// What became of every symbol of a derivation, for a stream that goes through it depth first.
struct ContextDecisions {
    struct Decision {
        int production = -1;     ///< that replaced the symbol; -1 = it stands in the derived string
        int step = 0;            ///< before which it stood there, from 0
        std::size_t first = 0;   ///< of the decisions of its successor's symbols, which follow one another
        std::size_t values = 0;  ///< where the parameters of its context begin, those of the left first
    };
    std::vector<Decision> symbols;  ///< those of the axiom first
    std::vector<double> values;
};

/// A symbol that stays for some steps draws anew in each.
constexpr DrawKey key_after(DrawKey key, int steps) {
    return steps == 0 ? key : key_below(~key, static_cast<std::uint64_t>(steps));
}

/// Rewrites until no production applies or the depth is reached. Every symbol of every step's string counts as a module.
/// Throws as derive().
ContextDecisions decide_by_context(const CompiledGrammar& grammar, DerivationLimits& limits, const Progress& progress);

}  // namespace rinceau
