#pragma once
// What the parts of update() share. Internal to the folder.

#include <functional>
#include <set>
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
void perform(Update& update, const DialogAction& action);
void perform(Update& update, const RecoveryAction& action);
void perform(Update& update, const GrowthAction& action);
void perform(Update& update, const SurfaceAction& action);

void tell(Update& update, MessageKind kind, std::string text);

/// What is shown is another one: its picture is asked for.
void show_anew(Update& update);

/// The document becomes `after`, and undo brings back the one from before. Drops a preview.
void record_edit(Update& update, Document after, const std::string& label);

/// An edit of the whole document.
struct DocumentEdit {
    std::string label;
    std::function<EditResult(const Grammar&)> grammar;
    /// For edits that give numbers other names and leave their values: the locked names in the document that is given,
    /// whose grammar is the edited one. Null = names stay, and locked numbers are put back.
    std::function<std::set<std::string>(const Document& after)> locked;
    std::function<void(Document& after)> rest;  ///< what else is different then; null = nothing
};

/// The edit of the document's grammar is made, locked numbers are put back (lsystem/keep_locked.h), the result is checked
/// (lsystem/check_edit.h; what is too large for one frame only when its picture is derived) and recorded, and what it
/// changed is told. If it throws InputError or LimitError this is told and nothing changes; nothing is recorded either if
/// nothing is different. True if it was recorded.
bool edit_document(Update& update, const DocumentEdit& edit);
bool edit_grammar(Update& update, const std::string& label, const std::function<EditResult(const Grammar&)>& edit);

/// The same as a preview of what the document would be; what goes wrong is not told while the mouse moves.
void preview_grammar(Update& update, const std::string& label, const std::function<EditResult(const Grammar&)>& edit);

/// What a tool previews, or is about to, is not wanted any more.
void drop_tool(EditorState& state);

/// What the panel of rules says is of the grammars that are shown now.
void refresh_rules(Update& update);
/// What was found while something else was dragged becomes the document's grammar as soon as nothing is.
void settle_analysis(Update& update);

/// The analysis that is only tried (TryAnalysis), if there is one, is stopped and what it found is dropped.
void drop_tried_analysis(Update& update);

/// The drawing is another one: nothing that an analysis of the last one brings is of use.
void forget_analysis(Update& update);
/// While the panel of growth is open, what it grows from follows the document.
void follow_growth(Update& update);
/// The field on a surface follows its settings.
void follow_surface(Update& update);
/// The document is another one: nothing has grown yet.
void forget_growth(Update& update);

/// What is previewed is not shown any more; nothing else changes.
void drop_preview(Update& update);

/// Another document takes the place of all: history, preview and selection begin anew.
void replace_document(Update& update, Document document);

}  // namespace rinceau
