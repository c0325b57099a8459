#pragma once
// Tools that change the whole grammar or what a symbol stands for. Every edit can be undone.

#include <variant>

#include "lsystem/randomize.h"

namespace rinceau {

struct RandomizeGrammar {
    RandomizeOptions options;
};
struct SymmetrizeGrammar {
    bool all_exceptions = false;
};

using ToolsAction = std::variant<RandomizeGrammar, SymmetrizeGrammar>;

}  // namespace rinceau
