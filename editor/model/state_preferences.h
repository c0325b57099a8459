#pragma once
// What of the state is kept on the disk although nobody saves it.

#include "editor/model/editor_state.h"
#include "editor/model/preferences.h"

namespace rinceau {

Preferences current_preferences(const EditorState& state);

void apply_preferences(EditorState& state, const Preferences& preferences);

/// Is a Tick needed soon: is something not kept yet that is to survive a crash?
bool wants_tick(const EditorState& state);

}  // namespace rinceau
