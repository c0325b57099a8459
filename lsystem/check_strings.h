#pragma once
// Mistakes in the strings of a grammar that is well formed as a text. Internal to the folder.

#include <string>
#include <vector>

#include "lsystem/grammar.h"
#include "lsystem/program.h"

namespace rinceau {

/// The message of an error without its place.
Warning warning_of(const InputError& error);

/// Unknown symbols and names, wrong numbers of arguments, brackets without a partner, numbers that a command does not take,
/// in a successor or the axiom. `scope` holds the names that the arguments may use.
std::vector<Warning> check_string(const Grammar& grammar, const std::vector<ModuleTemplate>& string, const Scope& scope);

}  // namespace rinceau
