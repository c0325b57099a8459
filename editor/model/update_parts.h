#pragma once
// What the parts of update() share. Internal to the folder.

#include <functional>
#include <string>

#include "editor/model/update.h"
#include "lsystem/edit_result.h"

namespace rinceau {

// One file each.
void perform(Update& update, const FileAction& action);
void perform(Update& update, const RulesAction& action);
void perform(Update& update, const ToolsAction& action);
void perform(Update& update, const CanvasAction& action);
void perform(Update& update, const AnalysisAction& action);
void perform(Update& update, const ShellAction& action);

void tell(Update& update, MessageKind kind, std::string text);

/// What is shown is another one: its picture is asked for.
void show_anew(Update& update);

/// The document becomes `after`, and undo brings back the one from before. Drops a preview.
void record_edit(Update& update, Document after, const std::string& label);

/// The edit of the document's grammar is made, locked numbers are put back (lsystem/keep_locked.h), the result is checked
/// (lsystem/check_edit.h) and recorded, and what it changed is told. If it throws InputError or LimitError this is told and nothing changes.
void edit_grammar(Update& update, const std::string& label, const std::function<EditResult(const Grammar&)>& edit);

/// The same as a preview of what the document would be; what goes wrong is not told while the mouse moves.
void preview_grammar(Update& update, const std::string& label, const std::function<EditResult(const Grammar&)>& edit);

/// What a tool previews, or is about to, is not wanted any more.
void drop_tool(EditorState& state);

/// What the panel of rules shows is said of the grammars that are shown and reset to, if these are others than before.
void refresh_rule_sheets(EditorState& state);
/// What was found while something else was dragged becomes the document's grammar as soon as nothing is.
void settle_analysis(Update& update);

/// The analysis that is only tried (TryAnalysis), if there is one, is stopped and what it found is dropped.
void drop_tried_analysis(Update& update);

/// The drawing is another one: nothing that an analysis of the last one brings is of use.
void forget_analysis(Update& update);

/// Another document takes the place of all: history, preview and selection begin anew.
void replace_document(Update& update, Document document);

}  // namespace rinceau
