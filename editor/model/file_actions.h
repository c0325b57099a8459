#pragma once
// Files: what a user asks for and what comes back.

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "editor/model/document.h"
#include "editor/model/file_stamp.h"
#include "editor/model/view_transform.h"

namespace rinceau {

// What leaves the document that is open asks first if it has unsaved changes.

/// A document with the smallest grammar that draws something.
struct NewDocument {};
/// Read a drawing, a grammar or a project. The document that is open stays until the new one is there.
struct OpenFile {
    std::string path;
};
/// The same as a beginning of a document of one's own: it has no file until it is saved.
struct OpenSample {
    std::string path;
};
/// Read the document's file anew.
struct RevertFile {};
/// The empty document takes the place of the one that is open.
struct CloseFile {};
/// Leave the program.
struct QuitEditor {};

/// The file is read: `document` is what it holds. A drawing has the flat list of its elements until its analysis is done.
struct FileOpened {
    std::string path;
    Document document;
    std::vector<std::string> warnings;
    std::optional<FileStamp> stamp;
    std::optional<ViewTransform> view;  ///< that a project was left with
    bool analyse = false;               ///< its rules are still to be found
    std::string absolute;               ///< the path from the root on; empty = the path is absolute
};
struct FileFailed {
    std::string path;
    std::string message;
};

/// Write the document where it came from; asks for a name if it has none or came from a drawing, and what to do if another
/// program has changed the file since.
struct SaveFile {
    bool even_if_changed = false;
};
/// The kind of file is that of the name's ending (file_kind.h); asks before another file is replaced.
struct SaveFileAs {
    std::string path;
    bool replace = false;
};
struct FileSaved {
    std::string path;
    Document document;  ///< that was written
    std::optional<FileStamp> stamp;
    std::vector<std::string> warnings;
};
struct SaveFailed {
    std::string path;
    std::string message;
};
/// The file was not written: it is not as it was when the editor read or wrote it.
struct FileChangedOutside {
    std::string path;
};

/// Another window has the file open.
struct FileHeldElsewhere {
    std::string path;
};

/// What an export can be told.
struct ExportChoices {
    int width = 0;             ///< of a PNG, in pixels; 0 = the picture's own
    bool live_random = false;  ///< draws by chance as such, where the format can
    friend constexpr bool operator==(const ExportChoices&, const ExportChoices&) = default;
};
/// Write the picture or the grammar for another program: `format` is a name of export_target.h. Asks before other files are
/// replaced.
struct ExportFile {
    std::string path;
    std::string format;
    ExportChoices choices;
    bool replace = false;
};
struct ExportProgress {
    std::string stage;
    double fraction = 0;
};
struct FileExported {
    std::string path;
    std::vector<std::string> notes;
};
struct ExportFailed {
    std::string path;
    std::string message;  ///< empty = it was cancelled
};
struct CancelExport {};

/// Nothing was written: files of these names would have been replaced. `again` would replace them.
struct WouldReplace {
    std::vector<std::string> names;
    std::variant<SaveFileAs, ExportFile> again;
};

/// The answer to FileState::question.
enum class FileAnswer : unsigned char { save, discard, replace, save_as, cancel };
struct AnswerFileQuestion {
    FileAnswer answer = FileAnswer::cancel;
};

struct FileAction
    : std::variant<NewDocument, OpenFile, OpenSample, RevertFile, CloseFile, QuitEditor, FileOpened, FileFailed, SaveFile,
                   SaveFileAs, FileSaved, SaveFailed, FileChangedOutside, FileHeldElsewhere, ExportFile, ExportProgress,
                   FileExported, ExportFailed, CancelExport, WouldReplace, AnswerFileQuestion> {
    using variant::variant;
    FileAction(const FileAction&);
    FileAction(FileAction&&) noexcept;
    FileAction& operator=(const FileAction&);
    FileAction& operator=(FileAction&&) noexcept;
    ~FileAction();
};

}  // namespace rinceau
