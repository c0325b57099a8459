#include "editor/model/editor_state.h"

#include <algorithm>

#include "editor/model/file_kind.h"
#include "lsystem/grammar_names.h"

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
           state.tools.running || state.tools.reading || state.clusters.running || state.clusters.mapping ||
           state.growth.asked || state.growth.work != GrowthWork::none || surface_is_busy(state.surface);
}

bool shows_tool_preview(const EditorState& state) {
    return state.preview && state.tools.previewed && state.preview->grammar == state.tools.previewed;
}

std::string window_title(const EditorState& state) {
    const std::string& path = state.file.path;
    const std::string name = path.empty() ? "Untitled" : path.substr(path.rfind('/') + 1);
    return (has_unsaved_changes(state) ? "*" : "") + name + " – Rinceau";
}

std::string selected_symbol(const EditorState& state) {
    if (!state.canvas.selection) return {};
    const std::string& symbol = selected_module(*state.canvas.selection).symbol;
    const auto symbols = symbols_of(*state.document.grammar);
    return std::ranges::count(symbols, symbol) > 0 ? symbol : std::string();
}

int selected_rule(const EditorState& state) {
    constexpr int none = -2;
    if (!state.canvas.selection) return none;
    const int production = selected_production(*state.canvas.selection);
    return production < static_cast<int>(state.document.grammar->productions.size()) ? production : none;
}

bool has_unsaved_changes(const EditorState& state) {
    const FileKind kind = kind_of_name(state.file.path);
    const bool grammar_alone = kind == FileKind::grammar || kind == FileKind::json_grammar;
    if (grammar_alone) return state.document.grammar != state.file.saved.grammar;
    return !same_version(state.document, state.file.saved);
}

}  // namespace rinceau
