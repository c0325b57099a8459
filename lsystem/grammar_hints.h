#pragma once
// What is right in a grammar but perhaps not meant.

#include <string>
#include <vector>

#include "lsystem/grammar.h"
#include "scene/input_error.h"

namespace rinceau {

/// Constants, styles, terminals and productions that nothing comes to; parameters with the name of a constant; symbols that
/// are ignored where there is no context. Of a grammar without mistakes, in order of place; of its parts only those that
/// stand in the file of this name: what other files offer need not be used.
std::vector<Warning> grammar_hints(const Grammar& grammar, const std::string& file_name);

}  // namespace rinceau
