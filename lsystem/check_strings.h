#pragma once
// Mistakes in the strings of a grammar that is well formed as a text. Internal to the folder.

#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "lsystem/grammar.h"
#include "lsystem/mistakes.h"
#include "lsystem/program.h"
#include "lsystem/style_table.h"

namespace rinceau {

/// What the strings of a grammar may refer to. Refers to the grammar, which must outlive it and stay as it is.
struct KnownNames {
    explicit KnownNames(const Grammar& grammar);

    StyleTable styles;
    std::unordered_set<std::string_view> terminals;
    std::unordered_map<std::string_view, std::vector<std::size_t>> arities;  ///< of a symbol's productions, each once
};

/// Unknown symbols and names, wrong numbers of arguments, brackets without a partner, numbers that a command does not take,
/// in a successor or the axiom. `scope` holds the names that the arguments may use.
std::vector<Warning> check_string(const KnownNames& names, const std::vector<ModuleTemplate>& string, const Scope& scope);

}  // namespace rinceau
