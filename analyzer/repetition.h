#pragma once
// Productions that repeat: P(m) : m > 0 -> .. P(m-1) at their end, m counting down.

#include <optional>
#include <string>

#include "analyzer/derivation_tree.h"
#include "lsystem/grammar.h"

namespace rinceau {

struct Repetition {
    std::string counter;  ///< name of m
    int production = 0;   ///< the symbol's only one; the call of itself is its last module
    int modules = 1;      ///< counted in an address for each repetition
};

/// Nothing if the symbol has several productions or repeats in another way, or not at all.
std::optional<Repetition> repetition_of(const Grammar& grammar, const std::string& symbol);

/// Which repetition of the production above it a node of the tree belongs to, from 0. `leaves` are those of the tree.
int turn_of(const DerivationTree& tree, const std::vector<Placement>& leaves, int node, const Repetition& repetition);

}  // namespace rinceau
