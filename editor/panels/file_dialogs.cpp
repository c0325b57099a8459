// Windows that ask about files.

#include "editor/panels/panel.h"

namespace rinceau {

Actions file_dialogs(const EditorState& state, const PanelTools&) {
    if (state.file.opening.empty()) return {};
    return {};
}

}  // namespace rinceau
