#pragma once
// What the parts of the panel of tools share. Internal to the folder.

#include "editor/panels/panel.h"

namespace rinceau {

constexpr float label_ems = 7;  ///< room for labels at the right of fields, in widths of a letter

/// The header of a tool's section; true = it is open. If it was asked for it opens, and the keyboard goes to its first
/// field.
bool tool_header(const EditorState& state, const PanelTools& tools, ToolSection section, const char* label,
                 Actions& actions);

// Sections, each in the file of its name.
void randomize_section(const EditorState& state, const PanelTools& tools, Actions& actions);

}  // namespace rinceau
