// Tools that change the whole grammar.

#include "editor/model/update_parts.h"
#include "lsystem/randomize.h"
#include "lsystem/symmetrize.h"

namespace rinceau {
namespace {

void perform_one(Update& update, const RandomizeGrammar& action) {
    edit_grammar(update, "randomize", [&](const Grammar& grammar) { return randomize(grammar, action.options); });
}

void perform_one(Update& update, const SymmetrizeGrammar& action) {
    edit_grammar(update, "symmetrize",
                 [&](const Grammar& grammar) { return symmetrize(grammar, {.all_exceptions = action.all_exceptions}); });
}

}  // namespace

void perform(Update& update, const ToolsAction& action) {
    std::visit([&](const auto& one) { perform_one(update, one); }, action);
}

}  // namespace rinceau
