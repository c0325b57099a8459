#pragma once
// From the words of a user to what takes the place of a symbol.

#include "editor/model/request.h"
#include "editor/model/tools_actions.h"

namespace rinceau {

/// Throws as read_replacement().
ToolsAction read_tool_replacement(const ReadReplacement& request);

}  // namespace rinceau
