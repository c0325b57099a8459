#pragma once
// The one way in which the editor changes.

#include "editor/model/action.h"
#include "editor/model/editor_state.h"
#include "editor/model/request.h"

namespace rinceau {

struct Update {
    EditorState state;
    Requests requests;
};

/// Pure: the same state and action give the same state and requests. Never throws but for want of memory: what goes wrong
/// is a message in the state, whose document is then as before.
Update update(EditorState state, const Action& action);

}  // namespace rinceau
