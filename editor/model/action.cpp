// How actions and requests are copied, moved and destroyed. Here once: the compiler takes long over it, and every panel and
// every step of the model makes some.

#include "editor/model/action.h"
#include "editor/model/request.h"

namespace rinceau {

Action::Action(const Action&) = default;
Action::Action(Action&&) noexcept = default;
Action& Action::operator=(const Action&) = default;
Action& Action::operator=(Action&&) noexcept = default;
Action::~Action() = default;

AnalysisAction::AnalysisAction(const AnalysisAction&) = default;
AnalysisAction::AnalysisAction(AnalysisAction&&) noexcept = default;
AnalysisAction& AnalysisAction::operator=(const AnalysisAction&) = default;
AnalysisAction& AnalysisAction::operator=(AnalysisAction&&) noexcept = default;
AnalysisAction::~AnalysisAction() = default;

CanvasAction::CanvasAction(const CanvasAction&) = default;
CanvasAction::CanvasAction(CanvasAction&&) noexcept = default;
CanvasAction& CanvasAction::operator=(const CanvasAction&) = default;
CanvasAction& CanvasAction::operator=(CanvasAction&&) noexcept = default;
CanvasAction::~CanvasAction() = default;

DialogAction::DialogAction(const DialogAction&) = default;
DialogAction::DialogAction(DialogAction&&) noexcept = default;
DialogAction& DialogAction::operator=(const DialogAction&) = default;
DialogAction& DialogAction::operator=(DialogAction&&) noexcept = default;
DialogAction::~DialogAction() = default;

FileAction::FileAction(const FileAction&) = default;
FileAction::FileAction(FileAction&&) noexcept = default;
FileAction& FileAction::operator=(const FileAction&) = default;
FileAction& FileAction::operator=(FileAction&&) noexcept = default;
FileAction::~FileAction() = default;

GrowthAction::GrowthAction(const GrowthAction&) = default;
GrowthAction::GrowthAction(GrowthAction&&) noexcept = default;
GrowthAction& GrowthAction::operator=(const GrowthAction&) = default;
GrowthAction& GrowthAction::operator=(GrowthAction&&) noexcept = default;
GrowthAction::~GrowthAction() = default;

RecoveryAction::RecoveryAction(const RecoveryAction&) = default;
RecoveryAction::RecoveryAction(RecoveryAction&&) noexcept = default;
RecoveryAction& RecoveryAction::operator=(const RecoveryAction&) = default;
RecoveryAction& RecoveryAction::operator=(RecoveryAction&&) noexcept = default;
RecoveryAction::~RecoveryAction() = default;

Request::Request(const Request&) = default;
Request::Request(Request&&) noexcept = default;
Request& Request::operator=(const Request&) = default;
Request& Request::operator=(Request&&) noexcept = default;
Request::~Request() = default;

RulesAction::RulesAction(const RulesAction&) = default;
RulesAction::RulesAction(RulesAction&&) noexcept = default;
RulesAction& RulesAction::operator=(const RulesAction&) = default;
RulesAction& RulesAction::operator=(RulesAction&&) noexcept = default;
RulesAction::~RulesAction() = default;

ShellAction::ShellAction(const ShellAction&) = default;
ShellAction::ShellAction(ShellAction&&) noexcept = default;
ShellAction& ShellAction::operator=(const ShellAction&) = default;
ShellAction& ShellAction::operator=(ShellAction&&) noexcept = default;
ShellAction::~ShellAction() = default;

SurfaceAction::SurfaceAction(const SurfaceAction&) = default;
SurfaceAction::SurfaceAction(SurfaceAction&&) noexcept = default;
SurfaceAction& SurfaceAction::operator=(const SurfaceAction&) = default;
SurfaceAction& SurfaceAction::operator=(SurfaceAction&&) noexcept = default;
SurfaceAction::~SurfaceAction() = default;

ToolsAction::ToolsAction(const ToolsAction&) = default;
ToolsAction::ToolsAction(ToolsAction&&) noexcept = default;
ToolsAction& ToolsAction::operator=(const ToolsAction&) = default;
ToolsAction& ToolsAction::operator=(ToolsAction&&) noexcept = default;
ToolsAction::~ToolsAction() = default;

}  // namespace rinceau
