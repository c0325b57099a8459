// Rules: previews that become edits, and undo.

#include <cstdlib>

#include "editor/model/update_rules.h"

namespace rinceau {

namespace {

void perform_one(Update& update, const CommitPreview&) {
    if (commit_drag(update) || !update.state.preview) return;
    Document after = std::move(*update.state.preview);
    record_edit(update, std::move(after), update.state.preview_label);
}

void perform_one(Update& update, const DropPreview&) {
    drop_tried_analysis(update);
    drop_tool(update.state);
    if (update.state.rules.dragged) update.state.rules.dragged->dropped = true;
    drop_preview(update);
}

/// One step; false if there is none.
bool step_in_history(Update& update, bool back) {
    EditorState& state = update.state;
    HistoryMove move = back ? undone(state.document, state.history) : redone(state.document, state.history);
    if (move.label.empty()) return false;
    tell(update, MessageKind::note, (back ? "Undone: " : "Redone: ") + move.label);
    state.document = std::move(move.document);
    state.history = std::move(move.history);
    return true;
}

void go_in_history(Update& update, int steps) {
    bool moved = false;
    for (int i = 0; i < std::abs(steps) && step_in_history(update, steps < 0); ++i) moved = true;
    if (!moved) return;
    update.state.preview.reset();
    update.state.rules.dragged.reset();
    update.state.rules.typed.reset();
    update.state.rules.written.reset();
    update.state.rules.removal.reset();
    show_anew(update);
}

void perform_one(Update& update, const UndoEdit&) { go_in_history(update, -1); }

void perform_one(Update& update, const RedoEdit&) { go_in_history(update, 1); }

void perform_one(Update& update, const GoInHistory& action) { go_in_history(update, action.steps); }

void perform_one(Update& update, const DepthMeasured& action) {
    RulesState& rules = update.state.rules;
    if (action.grammar == rules.measuring) rules.measuring.reset();
    rules.measured = action.grammar;
    rules.depth = action.depth;
}

void refresh_sheets(EditorState& state) {
    const auto refresh = [](std::shared_ptr<const RuleSheet>& sheet, const std::shared_ptr<const Grammar>& grammar) {
        if (!grammar) {
            sheet.reset();
        } else if (!sheet || sheet->grammar != grammar) {
            sheet = std::make_shared<const RuleSheet>(rule_sheet(grammar));
        }
    };
    refresh(state.rules.sheet, shown_document(state).grammar);
    if (state.document.origin == shown_document(state).grammar) {
        state.rules.origin = state.rules.sheet;
    } else {
        refresh(state.rules.origin, state.document.origin);
    }
}

/// One measurement at a time.
void measure_depth(Update& update) {
    EditorState& state = update.state;
    const auto& grammar = state.document.resolved;
    if (state.rules.measuring || state.rules.measured == grammar) return;
    state.rules.measuring = grammar;
    update.requests.push_back(MeasureDepth{state.document});
}

}  // namespace

void refresh_rules(Update& update) {
    refresh_sheets(update.state);
    refresh_text(update.state);
    measure_depth(update);
}

void perform(Update& update, const RulesAction& action) {
    std::visit([&](const auto& one) { perform_one(update, one); }, action);
}

}  // namespace rinceau
