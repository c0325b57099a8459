#pragma once
// Which productions of a symbol may apply, as far as it can be said without numbers. Internal to the folder.

#include <map>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

#include "lsystem/grammar.h"
#include "lsystem/program.h"

namespace rinceau {

/// A module as productions of one kind see it.
struct ProductionKey {
    ProductionKind kind = ProductionKind::rewriting;
    std::string_view symbol;
    std::size_t arguments = 0;
    friend auto operator<=>(const ProductionKey&, const ProductionKey&) = default;
};

struct ProductionFacts {
    bool always = false;           ///< no context, and no condition or one that is constant and holds
    bool never = false;            ///< a condition that is constant and does not hold
    std::optional<double> weight;  ///< if it is constant
};

/// Refers to the grammar that it was made from, which must outlive it and stay as it is.
struct ProductionOrder {
    /// The parameters of `constants` are constants whose value is not known.
    ProductionOrder(const Grammar& grammar, const Scope& constants);

    std::vector<ProductionFacts> facts;                       ///< by production
    std::map<ProductionKey, std::vector<std::size_t>> alike;  ///< those of one key, in the grammar's order

    /// The productions of a key that may apply: up to the first one that always does, and all with weight if one of these
    /// has.
    std::vector<std::size_t> that_may_apply(const Grammar& grammar, const ProductionKey& key) const;
    /// One of them applies whatever the numbers and neighbours are.
    bool applies_surely(const ProductionKey& key) const;
};

/// The names that a production's condition, weight and successor may use besides constants: its parameters and those of its
/// context, then `others`.
std::vector<std::string> names_in(const Production& production, const std::vector<std::string>& others = {});

ProductionKey key_of(const Production& production);

}  // namespace rinceau
