#pragma once
// Layers written into a grammar as z commands.

#include <vector>

#include "analyzer/derivation_tree.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// Raise what the module at the site draws by `by` layers (negative = lower), wherever it is derived.
struct SiteLayer {
    ModuleSite site;
    int by = 0;
    Expression expression;  ///< .. and by this, if it is not empty; the bracket of the site then ends behind the module
};

/// Raise what one module of the derivation draws. No exception stands at its address yet.
struct AddressLayer {
    std::vector<int> address;
    ModuleSite site;  ///< where the module stands in the text; its arguments use constants only
    int by = 0;
};

/// z(k) directly before the module; behind it z(-k), unless its bracket ends before anything else is drawn. The turtle goes
/// where it went before, and every module keeps its address.
Grammar with_layers(const Grammar& grammar, const std::vector<SiteLayer>& sites,
                    const std::vector<AddressLayer>& exceptions);

}  // namespace rinceau
