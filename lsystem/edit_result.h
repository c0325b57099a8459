#pragma once
// What an edit of a grammar gives back.

#include <string>
#include <vector>

#include "lsystem/grammar.h"

namespace rinceau {

/// Every edit is a function Grammar -> EditResult; it throws InputError if the edit makes no sense for the grammar.
struct EditResult {
    Grammar grammar;
    std::vector<std::string> changes;  ///< what is different now, one sentence without a full stop each; empty = nothing
};

}  // namespace rinceau
