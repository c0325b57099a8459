#pragma once
// Parts of one grammar taken over into another.

#include <string>

#include "lsystem/grammar_names.h"

namespace rinceau {

struct MergedGrammar {
    Grammar grammar;
    ModuleTemplates string;                      ///< `string` with its names in the grammar
    std::map<std::string, std::string> symbols;  ///< donor's name -> name in the grammar, of what has come along
};

/// The grammar with everything that `string`, a string of `donor`, draws: productions, terminals, constants and styles come
/// along under names that do not clash (a number behind those that do). A terminal or style that the grammar has in the same
/// words under the same name is shared. The donor's exceptions, seed and canvas do not come along; it must be resolved.
MergedGrammar merge_grammar(Grammar grammar, const Grammar& donor, const ModuleTemplates& string);

}  // namespace rinceau
