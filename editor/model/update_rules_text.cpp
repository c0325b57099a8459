// The grammar as text: written, checked in the background, applied.

#include "editor/model/update_rules.h"
#include "lsystem/grammar_text.h"

namespace rinceau {
namespace {

/// One check at a time: while one runs the text may grow on, and is checked again behind it.
void check_text(Update& update) {
    RuleText& text = update.state.rules.text;
    if (text.checking || text.checked == text.revision) return;
    text.checking = true;
    update.requests.push_back(CheckText{text.revision, text.text, text.file, update.state.document});
}

void show_place(RuleText& text, const SourcePlace& place) {
    text.line = place.line;
    text.column = place.column;
    text.goes_there = place.line > 0;
}

}  // namespace

void perform_one(Update& update, const ShowRules& action) {
    RulesState& rules = update.state.rules;
    if (rules.view == RulesView::text && action.view != RulesView::text && rules.text.changed)
        tell(update, MessageKind::warning,
             "The text has changes that are not applied: they are kept. Apply it (Ctrl+Enter) or revert it in the view "
             "Text.");
    rules.view = action.view;
}

void perform_one(Update& update, const WriteText& action) {
    RuleText& text = update.state.rules.text;
    if (action.text == text.text) return;
    text.text = action.text;
    text.changed = true;
    ++text.revision;
    text.line = 0;
    check_text(update);
}

void perform_one(Update& update, const TextChecked& action) {
    RuleText& text = update.state.rules.text;
    text.checking = false;
    if (action.revision == text.revision) {
        text.checked = action.revision;
        text.findings = action.findings;
    }
    check_text(update);
}

void perform_one(Update& update, const ApplyText&) {
    RuleText& text = update.state.rules.text;
    if (!text.changed) return;
    try {
        Grammar grammar = parse_grammar(text.text, text.file);
        const bool recorded = edit_grammar(update, "edit the text", [&](const Grammar&) -> EditResult {
            return {std::move(grammar), {}};
        });
        if (recorded) text.changed = false;  // and becomes that of the new grammar
    } catch (const InputError& error) {
        show_place(text, error.place());
        tell(update, MessageKind::mistake, std::string("The text is not applied: ") + error.what());
    }
}

void perform_one(Update& update, const RevertText&) {
    RuleText& text = update.state.rules.text;
    const bool checking = text.checking;
    text = rule_text_of(update.state.document, text.revision + 1);
    text.checking = checking;
}

void perform_one(Update& update, const ShowTextPlace& action) {
    RulesState& rules = update.state.rules;
    rules.view = RulesView::text;
    show_place(rules.text, {{}, action.line, action.column});
}

void perform_one(Update& update, const TextPlaceShown&) { update.state.rules.text.goes_there = false; }

void refresh_text(EditorState& state) {
    RulesState& rules = state.rules;
    if (rules.view != RulesView::text || rules.text.changed || rules.text.grammar == state.document.grammar) return;
    const bool checking = rules.text.checking;
    rules.text = rule_text_of(state.document, rules.text.revision + 1);
    rules.text.checking = checking;
}

}  // namespace rinceau
