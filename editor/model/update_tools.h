#pragma once
// What the parts of update_tools_*.cpp share. Internal to the folder.

#include "editor/model/update_parts.h"

namespace rinceau {

/// The edit of the document is asked for; if another one runs, it waits for it, and nothing else does.
void ask_for_tool(Update& update, std::shared_ptr<const ToolEdit> edit, bool preview);

// update_tools_replace.cpp
void perform_one(Update& update, const UseReplace& action);
void perform_one(Update& update, const ReplacementRead& action);
void perform_one(Update& update, const ReplacementFailed& action);

}  // namespace rinceau
