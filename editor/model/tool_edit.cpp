#include "editor/model/tool_edit.h"

#include <utility>

#include "lsystem/check_edit.h"
#include "lsystem/keep_locked.h"

namespace rinceau {
namespace {

EditResult edited(const Document& document, const RandomizeEdit& edit) { return randomize(*document.grammar, edit.options); }

EditResult edited(const Document& document, const SymmetrizeEdit& edit) {
    return symmetrize(*document.grammar, edit.options);
}

EditResult edited(const Document& document, const ReplaceEdit& edit) {
    ReplaceOptions options = edit.options;
    options.derive = document.derive;
    options.resolve = [&](const Grammar& grammar) { return *with_grammar(document, grammar).resolved; };
    return replace_symbols(*document.grammar, {edit.replacement}, options);
}

std::string label_of(const RandomizeEdit&) { return "randomize"; }
std::string label_of(const SymmetrizeEdit&) { return "symmetrize"; }
std::string label_of(const ReplaceEdit& edit) { return "replace " + edit.replacement.symbol; }

}  // namespace

std::shared_ptr<const ToolEdit> shared_edit(ToolEdit edit) { return std::make_shared<const ToolEdit>(std::move(edit)); }

std::string tool_label(const ToolEdit& edit) {
    return std::visit([](const auto& one) { return label_of(one); }, edit);
}

ToolResult use_tool(const Document& document, const ToolEdit& edit) {
    EditResult result = std::visit([&](const auto& one) { return edited(document, one); }, edit);
    CheckEditOptions options;
    options.derive = document.derive;
    options.for_drawing = [&](const Grammar& grammar) { return *with_grammar(document, grammar).resolved; };
    result = keep_locked(*document.grammar, std::move(result), document.locked);
    result = checked_edit(*document.grammar, std::move(result), options);
    const Document after = with_grammar(document, std::move(result.grammar));
    return {after.grammar, after.resolved, std::move(result.changes)};
}

bool is_quick_to_edit(const Document& document, std::size_t elements) {
    constexpr std::size_t few_elements = 1000;
    constexpr std::size_t few_modules = 2000;
    std::size_t modules = document.grammar->axiom.size();
    for (const Production& production : document.grammar->productions) modules += production.successor.size();
    for (const Exception& exception : document.grammar->exceptions) modules += 1 + exception.successor.size();
    return elements <= few_elements && modules <= few_modules;
}

}  // namespace rinceau
