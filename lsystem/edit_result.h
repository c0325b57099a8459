#pragma once
// What an edit of a grammar gives back.

#include <string>
#include <vector>

#include "lsystem/grammar.h"

namespace rinceau {

struct EditResult {
    Grammar grammar;
    std::vector<std::string> changes;  ///< what was changed, a sentence each, in the words of the grammar
};

}  // namespace rinceau
