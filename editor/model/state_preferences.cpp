#include "editor/model/state_preferences.h"

namespace rinceau {

Preferences current_preferences(const EditorState& state) {
    Preferences preferences = state.recovery.written;
    preferences.dark = state.shell.dark;
    preferences.recent = state.file.recent;
    preferences.last_folder = state.file.last_folder;
    return preferences;
}

void apply_preferences(EditorState& state, const Preferences& preferences) {
    state.recovery.written = preferences;
    state.recovery.interval = preferences.autosave_seconds;
    state.shell.dark = preferences.dark;
    state.file.recent = preferences.recent;
    state.file.last_folder = preferences.last_folder;
}

bool wants_tick(const EditorState& state) {
    const RecoveryState& recovery = state.recovery;
    const bool kept = recovery.kept && same_version(*recovery.kept, state.document);
    const bool copy = has_unsaved_changes(state) ? !kept : recovery.kept.has_value();
    return copy || recovery.writing || current_preferences(state) != recovery.written;
}

}  // namespace rinceau
