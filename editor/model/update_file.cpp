// Files: opening, saving, exporting, leaving.

#include "editor/model/update_parts.h"

namespace rinceau {
namespace {

void perform_one(Update& update, const OpenFile& action) {
    update.state.file.opening = action.path;
    update.requests.push_back(ReadDocument{action.path});
}

void perform_one(Update& update, const FileOpened& action) {
    if (action.path != update.state.file.opening) return;  // something else was opened since
    update.state.file = {.path = action.path, .saved_grammar = action.document.grammar};
    replace_document(update, action.document);
    for (const std::string& warning : action.warnings) tell(update, MessageKind::warning, warning);
    if (action.document.drawing) perform(update, AnalysisAction{StartAnalysis{action.document.analysis}});
}

void perform_one(Update& update, const FileFailed& action) {
    if (action.path == update.state.file.opening) update.state.file.opening.clear();
    tell(update, MessageKind::mistake, action.message);
}

void perform_one(Update& update, const SaveFile&) {
    update.requests.push_back(WriteDocument{update.state.file.path, update.state.document});
}

void perform_one(Update& update, const SaveFileAs& action) {
    update.requests.push_back(WriteDocument{action.path, update.state.document});
}

void perform_one(Update& update, const FileSaved& action) {
    update.state.file.path = action.path;
    update.state.file.saved_grammar = action.grammar;
    tell(update, MessageKind::note, action.path + " is saved");
}

void perform_one(Update& update, const SaveFailed& action) { tell(update, MessageKind::mistake, action.message); }

void perform_one(Update& update, const ExportFile& action) {
    update.requests.push_back(WriteExport{action.path, action.format, update.state.document});
}

void perform_one(Update& update, const FileExported& action) {
    tell(update, MessageKind::note, action.path + " is written");
    for (const std::string& note : action.notes) tell(update, MessageKind::warning, note);
}

void perform_one(Update& update, const QuitEditor&) { update.requests.push_back(CloseWindow{}); }

}  // namespace

void perform(Update& update, const FileAction& action) {
    std::visit([&](const auto& one) { perform_one(update, one); }, action);
}

}  // namespace rinceau
