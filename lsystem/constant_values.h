#pragma once
// What expressions are worth without parameters. Internal to the folder.

#include <optional>
#include <string>

#include "lsystem/grammar.h"
#include "lsystem/program.h"

namespace rinceau {

/// The constants that have a value; those that do not (a mistake, a name of a file that is used) are left out.
Scope constants_of(const Grammar& grammar);

/// Nothing if the expression uses an unknown name, a parameter or random numbers, or is not finite.
std::optional<double> value_of(const Expression& expression, const Scope& constants);

/// Is it one number, as written?
bool is_plain_number(const Expression& expression);

/// The index of the constant whose name the whole expression is, through other constants of that kind; -1 = none.
int constant_behind(const Grammar& grammar, const Expression& expression);

}  // namespace rinceau
