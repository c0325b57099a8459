#pragma once
// Everything that can happen to the editor.

#include <variant>
#include <vector>

#include "editor/model/analysis_actions.h"
#include "editor/model/canvas_actions.h"
#include "editor/model/dialog_actions.h"
#include "editor/model/file_actions.h"
#include "editor/model/growth_actions.h"
#include "editor/model/recovery_actions.h"
#include "editor/model/rules_actions.h"
#include "editor/model/shell_actions.h"
#include "editor/model/surface_actions.h"
#include "editor/model/tools_actions.h"

namespace rinceau {

struct Action : std::variant<FileAction, RulesAction, ToolsAction, CanvasAction, AnalysisAction, ShellAction, DialogAction,
                             RecoveryAction, GrowthAction, SurfaceAction> {
    using variant::variant;
    Action(const Action&);
    Action(Action&&) noexcept;
    Action& operator=(const Action&);
    Action& operator=(Action&&) noexcept;
    ~Action();
};
using Actions = std::vector<Action>;

}  // namespace rinceau
