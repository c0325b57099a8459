// Rules: previews that become edits, and undo.

#include "editor/model/update_rules.h"

namespace rinceau {

void drop_preview(Update& update) {
    if (!update.state.preview) return;
    update.state.preview.reset();
    show_anew(update);
}

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

void move_in_history(Update& update, HistoryMove move, const char* what) {
    if (move.label.empty()) return;
    tell(update, MessageKind::note, what + move.label);
    update.state.document = std::move(move.document);
    update.state.history = std::move(move.history);
    update.state.preview.reset();
    update.state.rules.dragged.reset();
    update.state.rules.typed.reset();
    show_anew(update);
}

void perform_one(Update& update, const UndoEdit&) {
    move_in_history(update, undone(update.state.document, update.state.history), "Undone: ");
}

void perform_one(Update& update, const RedoEdit&) {
    move_in_history(update, redone(update.state.document, update.state.history), "Redone: ");
}

}  // namespace

void perform(Update& update, const RulesAction& action) {
    std::visit([&](const auto& one) { perform_one(update, one); }, action);
}

}  // namespace rinceau
