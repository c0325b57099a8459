#pragma once
// All that the editor knows, as one value.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/model/analysis_state.h"
#include "editor/model/canvas_state.h"
#include "editor/model/clusters_state.h"
#include "editor/model/derived_picture.h"
#include "editor/model/dialog_state.h"
#include "editor/model/document.h"
#include "editor/model/file_state.h"
#include "editor/model/growth_state.h"
#include "editor/model/history.h"
#include "editor/model/recovery_state.h"
#include "editor/model/rules_state.h"
#include "editor/model/shell_state.h"
#include "editor/model/surface_state.h"
#include "editor/model/tools_state.h"

namespace rinceau {

enum class MessageKind : unsigned char { note, warning, mistake };

/// What happened and what to do, for the user.
struct EditorMessage {
    MessageKind kind = MessageKind::note;
    std::string text;
};

struct EditorState {
    Document document;
    History history;
    std::optional<Document> preview;  ///< what is shown instead while something is dragged
    std::string preview_label;        ///< what the edit will be called
    std::uint64_t revision = 0;       ///< of what is shown; grows with each change

    std::shared_ptr<const DerivedPicture> picture;  ///< the last that could be derived; null at first
    std::uint64_t picture_revision = 0;             ///< of what it shows
    std::string picture_mistake;                    ///< why what is shown has no picture; empty = it has, or will have

    FileState file;
    DialogState dialog;
    RecoveryState recovery;
    RulesState rules;
    ToolsState tools;
    CanvasState canvas;
    AnalysisState analysis;
    ClustersState clusters;
    GrowthState growth;
    SurfaceState surface;
    ShellState shell;
    std::vector<EditorMessage> messages;  ///< oldest first
};

/// A state with an empty document.
EditorState initial_state();

/// What is to be seen: the preview, or the document.
const Document& shown_document(const EditorState& state);

/// Is the preview that is shown of a tool?
bool shows_tool_preview(const EditorState& state);

/// Is something being read, derived or analysed, so that more will change by itself?
bool is_busy(const EditorState& state);

/// "facade.lsys – Rinceau", with a "*" before it if there are unsaved changes.
std::string window_title(const EditorState& state);

/// Would be lost if the window closed now: compared with what the file holds, by versions. A file of a grammar alone does
/// not hold locks and options. Quick, for every frame.
/// The symbol that is selected on the canvas, if it is one of the document's grammar; empty = none.
std::string selected_symbol(const EditorState& state);

/// The index of the document's production in which the selected symbol stands; -1 = the axiom, -2 = none.
int selected_rule(const EditorState& state);

bool has_unsaved_changes(const EditorState& state);

}  // namespace rinceau
