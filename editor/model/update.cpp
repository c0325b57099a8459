#include "editor/model/update.h"

#include <optional>
#include <utility>

#include "editor/model/update_parts.h"
#include "lsystem/check_edit.h"
#include "lsystem/keep_locked.h"

namespace rinceau {
namespace {

/// What is checked between two frames.
constexpr std::uint64_t modules_checked = 200'000;

EditResult checked(const Document& document, EditResult result) {
    CheckEditOptions options;
    options.derive = document.derive;
    options.unchecked_above = modules_checked;
    options.for_drawing = [&](const Grammar& grammar) { return *with_grammar(document, grammar).resolved; };
    return checked_edit(*document.grammar, std::move(result), options);
}

/// Throws as edits do; nothing if the document stays as it is.
std::optional<Document> edited(const Document& before, const DocumentEdit& edit, std::vector<std::string>& changes) {
    EditResult result = edit.grammar(*before.grammar);
    if (!edit.locked) result = keep_locked(*before.grammar, std::move(result), before.locked);
    result = checked(before, std::move(result));
    Document after = with_grammar(before, std::move(result.grammar));
    if (edit.locked) after.locked = edit.locked(after);
    if (edit.rest) edit.rest(after);
    const bool same = result.changes.empty() && same_document(before, after);
    changes = std::move(result.changes);
    if (same) return std::nullopt;
    return after;
}

}  // namespace

void tell(Update& update, MessageKind kind, std::string text) {
    constexpr std::size_t most_messages = 500;
    auto& messages = update.state.messages;
    if (messages.size() >= most_messages) messages.erase(messages.begin());
    messages.push_back({kind, std::move(text)});
}

void show_anew(Update& update) {
    ++update.state.revision;
    update.requests.push_back(DerivePicture{update.state.revision, shown_document(update.state)});
}

void record_edit(Update& update, Document after, const std::string& label) {
    EditorState& state = update.state;
    state.history = recorded(std::move(state.history), state.document, label);
    state.document = std::move(after);
    state.preview.reset();
    show_anew(update);
}

bool edit_document(Update& update, const DocumentEdit& edit) {
    try {
        std::vector<std::string> changes;
        std::optional<Document> after = edited(update.state.document, edit, changes);
        for (std::string& change : changes) tell(update, MessageKind::note, std::move(change));
        if (after) {
            record_edit(update, std::move(*after), edit.label);
            return true;
        }
        tell(update, MessageKind::note, "Nothing is different after: " + edit.label);
    } catch (const InputError& error) {
        tell(update, MessageKind::mistake, error.what());
    } catch (const LimitError& error) {
        tell(update, MessageKind::mistake, error.what());
    }
    return false;
}

bool edit_grammar(Update& update, const std::string& label, const std::function<EditResult(const Grammar&)>& edit) {
    return edit_document(update, {.label = label, .grammar = edit, .locked = {}, .rest = {}});
}

void preview_grammar(Update& update, const std::string& label, const std::function<EditResult(const Grammar&)>& edit) {
    EditorState& state = update.state;
    try {
        const Document& document = state.document;
        EditResult result = keep_locked(*document.grammar, edit(*document.grammar), document.locked);
        state.preview = with_grammar(document, std::move(result.grammar));
        state.preview_label = label;
        show_anew(update);
    } catch (const InputError&) {  // the mouse may come back to where the edit makes sense
    } catch (const LimitError&) {
    }
}

void drop_preview(Update& update) {
    if (!update.state.preview) return;
    update.state.preview.reset();
    show_anew(update);
}

void replace_document(Update& update, Document document) {
    EditorState& state = update.state;
    state.document = std::move(document);
    if (!state.document.origin) state.document.origin = state.document.grammar;
    state.history = {};
    state.preview.reset();
    forget_analysis(update);
    forget_growth(update);
    state.canvas.fit_pending = true;
    state.canvas.drag.reset();
    state.canvas.onion = OnionMode::off;
    state.canvas.before.reset();
    perform(update, CanvasAction{ClearSelection{}});
    show_anew(update);
}

Update update(EditorState state, const Action& action) {
    Update result{std::move(state), {}};
    std::visit([&](const auto& of_area) { perform(result, of_area); }, action);
    settle_analysis(result);
    follow_growth(result);
    follow_surface(result);
    refresh_rules(result);
    return result;
}

}  // namespace rinceau
