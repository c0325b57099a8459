#pragma once
// Which names a grammar has, which of them are used, and other names for them.

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "lsystem/grammar.h"

namespace rinceau {

using ModuleTemplates = std::vector<ModuleTemplate>;

/// What a string uses, directly or through productions.
struct UsedNames {
    std::set<std::string> symbols;
    std::set<std::string> constants;
    std::set<int> styles;
    bool any_style = false;  ///< `;(n)` computes the number of a style
};

/// What is used by what derives from `from`.
UsedNames used_names(const Grammar& grammar, const ModuleTemplates& from);

/// What is used by the axiom and the exceptions.
UsedNames used_names(const Grammar& grammar);

/// The symbols that have a production, a terminal or a place in a string, but commands, in this order, each once.
std::vector<std::string> symbols_of(const Grammar& grammar);

/// True if what it draws may depend on the seed.
bool draws_random_numbers(const Grammar& grammar);

/// Is it a name that a symbol can have: no command, function, constant of expressions or word of the language?
bool may_name_symbol(const std::string& name);

/// A name like `wanted` that is neither taken nor a command or a word of the language: with a number behind it if need be.
std::string free_name(const std::string& wanted, const std::function<bool(const std::string&)>& taken);

/// The grammar without what was used before and is used no more: productions, terminals, constants, styles; their names go
/// to `removed`.
struct WithoutLeftovers {
    Grammar grammar;
    std::vector<std::string> removed;
};
WithoutLeftovers without_leftovers(Grammar grammar, const UsedNames& before);

/// A module of a string that is a single literal number: `;(2)`.
const double* literal_argument(const ModuleTemplate& module);

}  // namespace rinceau
