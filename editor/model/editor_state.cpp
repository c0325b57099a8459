#include "editor/model/editor_state.h"

#include "editor/model/file_kind.h"

namespace rinceau {

EditorState initial_state() {
    EditorState state;
    state.document = empty_document();
    state.file.saved = state.document;
    return state;
}

const Document& shown_document(const EditorState& state) { return state.preview ? *state.preview : state.document; }

bool is_busy(const EditorState& state) {
    const bool derives = state.picture_revision != state.revision && state.picture_mistake.empty();
    return derives || state.analysis.running || state.file.opening || state.file.saving || state.file.exporting ||
           state.tools.running || state.tools.reading;
}

bool shows_tool_preview(const EditorState& state) {
    return state.preview && state.tools.previewed && state.preview->grammar == state.tools.previewed;
}

std::string window_title(const EditorState& state) {
    const std::string& path = state.file.path;
    const std::string name = path.empty() ? "Untitled" : path.substr(path.rfind('/') + 1);
    return (has_unsaved_changes(state) ? "*" : "") + name + " – Rinceau";
}

bool has_unsaved_changes(const EditorState& state) {
    const FileKind kind = kind_of_name(state.file.path);
    const bool grammar_alone = kind == FileKind::grammar || kind == FileKind::json_grammar;
    if (grammar_alone) return state.document.grammar != state.file.saved.grammar;
    return !same_version(state.document, state.file.saved);
}

}  // namespace rinceau
