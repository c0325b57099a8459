#pragma once
// What happens in a derivation: the numbers that modules have, how deep it goes.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "lsystem/derive.h"
#include "lsystem/grammar.h"

namespace rinceau {

struct ArgumentRange {
    double lowest = 0;
    double highest = 0;
    bool whole = true;  ///< all of them are whole numbers
};

struct DerivationFacts {
    /// Of the modules of a symbol with so many arguments, rewritten or not: a range per argument.
    std::map<std::pair<std::string, std::size_t>, std::vector<ArgumentRange>> arguments;
    int depth = 0;  ///< most productions one inside the other
};

/// Throws as derive().
DerivationFacts derivation_facts(const Grammar& grammar, const DeriveOptions& options = {}, const Progress& progress = {});

}  // namespace rinceau
