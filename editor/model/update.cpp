#include "editor/model/update.h"

#include <utility>

#include "editor/model/update_parts.h"
#include "lsystem/check_edit.h"
#include "lsystem/keep_locked.h"

namespace rinceau {
namespace {

EditResult checked(const Update& update, const std::function<EditResult(const Grammar&)>& edit) {
    const Document& document = update.state.document;
    CheckEditOptions options;
    options.derive = document.derive;
    options.for_drawing = [&](const Grammar& grammar) { return *with_grammar(document, grammar).resolved; };
    EditResult result = keep_locked(*document.grammar, edit(*document.grammar), document.locked);
    return checked_edit(*document.grammar, std::move(result), options);
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

void edit_grammar(Update& update, const std::string& label, const std::function<EditResult(const Grammar&)>& edit) {
    try {
        EditResult result = checked(update, edit);
        Document after = with_grammar(update.state.document, std::move(result.grammar));
        for (std::string& change : result.changes) tell(update, MessageKind::note, std::move(change));
        record_edit(update, std::move(after), label);
    } catch (const InputError& error) {
        tell(update, MessageKind::mistake, error.what());
    } catch (const LimitError& error) {
        tell(update, MessageKind::mistake, error.what());
    }
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

void replace_document(Update& update, Document document) {
    EditorState& state = update.state;
    state.document = std::move(document);
    if (!state.document.origin) state.document.origin = state.document.grammar;
    if (state.document.drawing && !state.document.found) state.document.found = state.document.grammar;
    state.history = {};
    state.preview.reset();
    forget_analysis(update);
    state.canvas.fit_pending = true;
    state.canvas.drag.reset();
    perform(update, CanvasAction{ClearSelection{}});
    show_anew(update);
}

Update update(EditorState state, const Action& action) {
    Update result{std::move(state), {}};
    std::visit([&](const auto& of_area) { perform(result, of_area); }, action);
    settle_analysis(result);
    refresh_rule_sheets(result.state);
    return result;
}

}  // namespace rinceau
