#pragma once
// use "vine.lsys" as vine: several files become one grammar.

#include <functional>
#include <string>
#include <vector>

#include "lsystem/grammar.h"
#include "scene/input_error.h"

namespace rinceau {

/// The text of a file; throws InputError or LimitError if it cannot be read.
using GrammarLoader = std::function<std::string(const std::string& file)>;

/// The grammar with the constants, productions, styles, terminals and ignored symbols of all files that it uses, and that
/// these use, in the place of its uses. The names of a file that is used under a prefix begin with the prefix and '_'; its
/// styles get numbers of their own. A file's name is taken from the folder of the file that says so (Use::place). What
/// comes along twice under the same name is there once. Axiom, exceptions, canvas, title, seed and comments of a used
/// file do not come along.
/// Throws InputError, at the place of the mistake, for a file that cannot be read or has mistakes, a circle of uses, more
/// than 16 files one inside the other, more than 16 MiB of text, and a name that two files give.
Grammar resolve_uses(const Grammar& grammar, const GrammarLoader& load);

struct ResolvedGrammar {
    Grammar grammar;  ///< as far as it could be put together
    std::vector<Warning> mistakes;
};

/// The same, naming every mistake.
ResolvedGrammar resolve_uses_with_mistakes(const Grammar& grammar, const GrammarLoader& load);

}  // namespace rinceau
