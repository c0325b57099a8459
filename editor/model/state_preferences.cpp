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

}  // namespace rinceau
