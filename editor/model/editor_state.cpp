#include "editor/model/editor_state.h"

#include "lsystem/grammar_text.h"

namespace rinceau {

EditorState initial_state() {
    EditorState state;
    state.document = empty_document();
    state.file.saved_grammar = state.document.grammar;
    return state;
}

const Document& shown_document(const EditorState& state) { return state.preview ? *state.preview : state.document; }

bool shows_tool_preview(const EditorState& state) {
    return state.preview && state.tools.previewed && state.preview->grammar == state.tools.previewed;
}

bool is_busy(const EditorState& state) {
    const bool derives = state.picture_revision != state.revision && state.picture_mistake.empty();
    return derives || state.analysis.running || state.tools.running || state.tools.reading || !state.file.opening.empty();
}

bool has_unsaved_changes(const EditorState& state) {
    return state.document.grammar != state.file.saved_grammar &&
           (!state.file.saved_grammar || to_text(*state.document.grammar) != to_text(*state.file.saved_grammar));
}

}  // namespace rinceau
