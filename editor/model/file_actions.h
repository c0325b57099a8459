#pragma once
// Files: what a user asks for and what comes back.

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "editor/model/document.h"

namespace rinceau {

/// Read a drawing or a grammar. The document that is open stays until the new one is there.
struct OpenFile {
    std::string path;
};
/// The file is read: `document` is what it holds; a drawing has an empty grammar until its analysis is done.
struct FileOpened {
    std::string path;
    Document document;
    std::vector<std::string> warnings;
};
struct FileFailed {
    std::string path;
    std::string message;
};
/// Write the document where it came from; asks for a name if it has none.
struct SaveFile {};
struct SaveFileAs {
    std::string path;
};
struct FileSaved {
    std::string path;
    std::shared_ptr<const Grammar> grammar;  ///< that was written
};
struct SaveFailed {
    std::string path;
    std::string message;
};
/// Write the picture or the grammar for another program: `format` is svg, png, pdf or a name of exports/export_formats.h.
struct ExportFile {
    std::string path;
    std::string format;
};
struct FileExported {
    std::string path;
    std::vector<std::string> notes;
};
/// Leave the program; asks if there are unsaved changes.
struct QuitEditor {};

using FileAction = std::variant<OpenFile, FileOpened, FileFailed, SaveFile, SaveFileAs, FileSaved, SaveFailed, ExportFile,
                                FileExported, QuitEditor>;

}  // namespace rinceau
