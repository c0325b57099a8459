#pragma once
// Which parts of the state are preferences.

#include "editor/model/editor_state.h"
#include "editor/model/preferences.h"

namespace rinceau {

Preferences current_preferences(const EditorState& state);

void apply_preferences(EditorState& state, const Preferences& preferences);

}  // namespace rinceau
