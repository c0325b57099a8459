#pragma once
// What the editor knows of files.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "editor/model/file_actions.h"

namespace rinceau {

/// What is to happen once the document that is open may go.
struct FileIntent {
    enum class Kind : unsigned char { create, open, sample, recover, revert, close, quit };
    Kind kind = Kind::close;
    std::string path;  ///< open, sample, recover
    friend bool operator==(const FileIntent&, const FileIntent&) = default;
};

// What the user is asked.
struct UnsavedQuestion {
    FileIntent then;
};
struct ReplaceQuestion {
    std::vector<std::string> names;
    std::variant<SaveFileAs, ExportFile> again;
};
struct ChangedQuestion {
    std::string path;
};
using FileQuestion = std::variant<UnsavedQuestion, ReplaceQuestion, ChangedQuestion>;

/// An export that runs.
struct RunningExport {
    std::string path;
    std::string stage;
    double fraction = 0;
};

struct FileState {
    std::string path;                ///< of the document; empty = it has never been saved or opened
    Document saved;                  ///< what the file holds
    std::optional<FileStamp> stamp;  ///< of the file when it was read or written; none = it is not known
    bool awaits_rules = false;       ///< the grammar is the flat list of a drawing that was just opened

    std::optional<FileIntent> opening;  ///< what is being read
    Document left;                      ///< the document that was agreed to go for it
    bool saving = false;
    std::optional<FileIntent> after_saving;
    std::optional<RunningExport> exporting;
    std::optional<FileQuestion> question;
    std::vector<std::string> recent;  ///< files, the newest first
    std::string last_folder;          ///< that a file was opened from or saved to
};

}  // namespace rinceau
