// Commands of the menu File.

#include "editor/model/command.h"

namespace rinceau {
namespace {

Command show_dialog(std::string name, std::string label, std::string shortcut, std::string help,
                    Action (*action)(const EditorState&)) {
    return {.name = std::move(name),
            .menu = "File",
            .label = std::move(label),
            .shortcut = std::move(shortcut),
            .help = std::move(help),
            .action = action};
}

bool has_file(const EditorState& state) { return !state.file.path.empty(); }

}  // namespace

std::vector<Command> file_commands() {
    return {
        show_dialog("file.new", "New", "Ctrl+N", "Begins with a row of three squares.",
                    [](const EditorState&) -> Action { return FileAction{NewDocument{}}; }),
        show_dialog("file.sample", "New from a sample...", "Ctrl+Shift+N", "Begins with one of the samples.",
                    [](const EditorState&) -> Action { return DialogAction{ShowPickList{PickList::Of::samples}}; }),
        show_dialog("file.open", "Open...", "Ctrl+O", "Opens a drawing, a grammar or a project.",
                    [](const EditorState&) -> Action { return DialogAction{ShowFileDialog{FilePurpose::open}}; }),
        show_dialog("file.recent", "Open recent...", "Ctrl+Shift+O", "Opens a file that was open lately.",
                    [](const EditorState&) -> Action { return DialogAction{ShowPickList{PickList::Of::recent}}; }),
        show_dialog("file.save", "Save", "Ctrl+S", "Writes the document to its file; asks for a name if it has none.",
                    [](const EditorState&) -> Action { return FileAction{SaveFile{}}; }),
        show_dialog("file.save_as", "Save as...", "Ctrl+Shift+S",
                    "Writes all of it as a project, or its grammar, under another name.",
                    [](const EditorState&) -> Action { return DialogAction{ShowFileDialog{FilePurpose::save}}; }),
        show_dialog("file.export", "Export...", "Ctrl+E", "Writes the picture, or the rules for another program.",
                    [](const EditorState&) -> Action { return DialogAction{ShowFileDialog{FilePurpose::export_picture}}; }),
        {.name = "file.stop_export",
         .menu = "File",
         .label = "Stop the export",
         .shortcut = "",
         .help = "Nothing is written then.",
         .enabled = [](const EditorState& state) { return state.file.exporting.has_value(); },
         .action = [](const EditorState&) -> Action { return FileAction{CancelExport{}}; }},
        {.name = "file.revert",
         .menu = "File",
         .label = "Revert",
         .shortcut = "",
         .help = "Reads the file anew.",
         .enabled = has_file,
         .action = [](const EditorState&) -> Action { return FileAction{RevertFile{}}; }},
        show_dialog("file.close", "Close", "Ctrl+W", "Closes the document and keeps the window.",
                    [](const EditorState&) -> Action { return FileAction{CloseFile{}}; }),
        show_dialog("file.quit", "Quit", "Ctrl+Q", "Leaves; asks if something is not saved.",
                    [](const EditorState&) -> Action { return FileAction{QuitEditor{}}; }),
    };
}

}  // namespace rinceau
