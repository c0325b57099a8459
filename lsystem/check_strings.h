#pragma once
// Mistakes in the strings of a grammar that is well formed as a text. Internal to the folder.

#include <map>
#include <optional>
#include <set>
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
    /// `spoilt`: names that statements were to give that could not be read; nothing is said of them. `complete`: no file
    /// with other names is missing; else nothing is said of any unknown name.
    KnownNames(const Grammar& grammar, std::set<std::string> spoilt, bool complete);

    StyleTable styles;
    std::unordered_set<std::string_view> terminals;
    std::unordered_map<std::string_view, std::vector<std::size_t>> arities;  ///< of a symbol's productions, each once
    std::unordered_set<std::string_view> watched;  ///< symbols that contexts name: they have a meaning without a drawing
    std::map<std::string_view, std::set<std::size_t>> occurring;  ///< numbers of arguments in axiom, successors, exceptions
    std::set<std::string> spoilt;
    bool complete = true;

    bool is_excused(const std::string& name) const { return !complete || spoilt.contains(name); }

    std::vector<std::string_view> symbols;  ///< with productions or drawings: what an unknown one may be meant to be
};

struct CheckedExpression {
    std::vector<Warning> mistakes;   ///< every unknown name; else a constant value that is not finite
    std::optional<Program> program;  ///< if all names are known and there is no mistake
};

CheckedExpression check_expression(const KnownNames& names, const Expression& expression, const Scope& scope,
                                   const SourcePlace& place);

/// Unknown symbols and names, wrong numbers of arguments, brackets without a partner, numbers that a command does not take,
/// in a successor or the axiom. `scope` holds the names that the arguments may use.
std::vector<Warning> check_string(const KnownNames& names, const std::vector<ModuleTemplate>& string, const Scope& scope);

}  // namespace rinceau
