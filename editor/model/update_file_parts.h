#pragma once
// What update_file.cpp and update_file_save.cpp share. Internal to the folder.

#include <string>

#include "editor/model/update_parts.h"

namespace rinceau {

/// The intent, at once or after the question what becomes of unsaved changes.
void ask_or_perform(Update& update, const FileIntent& intent);
/// Without asking.
void perform_intent(Update& update, const FileIntent& intent);

/// The part of the scene that a project was left with, on a canvas of the size that it has here.
void show_view(EditorState& state, const ViewTransform& view);

/// The file is the newest of the recent ones.
void note_recent(FileState& file, const std::string& path);

// update_file_save.cpp
void perform_saving(Update& update, const SaveFile& action);
void perform_saving(Update& update, const SaveFileAs& action);
void perform_saving(Update& update, const FileSaved& action);
void perform_saving(Update& update, const SaveFailed& action);
void perform_saving(Update& update, const FileChangedOutside& action);
void perform_saving(Update& update, const ExportFile& action);
void perform_saving(Update& update, const ExportProgress& action);
void perform_saving(Update& update, const FileExported& action);
void perform_saving(Update& update, const ExportFailed& action);
void perform_saving(Update& update, const CancelExport& action);
void perform_saving(Update& update, const WouldReplace& action);

}  // namespace rinceau
