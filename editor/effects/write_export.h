#pragma once
// The picture or the grammar for another program.

#include <string>
#include <vector>

#include "editor/model/document.h"
#include "editor/model/file_actions.h"
#include "geometry/progress.h"

namespace rinceau {

/// What an export writes, made but not written.
struct ExportedFiles {
    struct File {
        std::string path;
        std::string bytes;
    };
    std::vector<File> files;         ///< companions first, the file that was asked for last
    std::vector<std::string> notes;  ///< what the format cannot hold
};

/// The document's picture or its grammar in a format of export_target.h. Throws InputError and LimitError, and what
/// `progress` throws.
ExportedFiles make_export(const Document& document, const ExportFile& what, const Progress& progress = {});

/// Those of the files that stand there already.
std::vector<std::string> files_to_replace(const ExportedFiles& made);

/// Writes all files, or none if it is plain beforehand that one of them cannot be written; each is whole before and
/// afterwards. Throws OutputError.
void write_export(const ExportedFiles& made);

}  // namespace rinceau
