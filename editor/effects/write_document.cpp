#include "editor/effects/write_document.h"

#include <exception>
#include <filesystem>
#include <new>

#include "editor/effects/folders.h"
#include "editor/model/file_kind.h"
#include "editor/model/project.h"
#include "exports/json_grammar.h"
#include "files/files.h"
#include "lsystem/grammar_text.h"

namespace rinceau {
namespace {

std::string document_bytes(const WriteDocument& request) {
    switch (kind_of_name(request.path)) {
        case FileKind::project:
            return to_json(Project{request.document, request.view, {}});
        case FileKind::json_grammar:
            return to_json(*request.document.grammar).bytes;
        default:
            return to_text(*request.document.grammar);
    }
}

/// Files that the grammar uses and that are not where the written file will look for them.
std::vector<std::string> use_warnings(const WriteDocument& request) {
    std::vector<std::string> warnings;
    const auto folder = std::filesystem::path(request.path).parent_path();
    for (const Use& use : request.document.grammar->uses) {
        std::error_code ignored;
        if (std::filesystem::exists(folder / use.file, ignored)) continue;
        warnings.push_back(file_name_of(request.path) + " uses " + use.file + ", which is not beside it in " +
                           folder.string() + ": copy it there, or save a project, which holds it");
    }
    return warnings;
}

std::string still_open(const std::string& message) { return message + ". The document stays open, unsaved"; }

}  // namespace

FileAction write_document(const WriteDocument& request) {
    try {
        const std::optional<FileStamp> there = stamp_of(request.path);
        if (there && !request.replace) return WouldReplace{{request.path}, SaveFileAs{request.path, true}};
        if (there && request.expected && *there != *request.expected) return FileChangedOutside{request.path};
        write_output(request.path, document_bytes(request));
        const bool grammar_alone = kind_of_name(request.path) != FileKind::project;
        return FileSaved{request.path, request.document, stamp_of(request.path),
                         grammar_alone ? use_warnings(request) : std::vector<std::string>()};
    } catch (const std::bad_alloc&) {
        return SaveFailed{request.path, still_open(request.path + ": the memory does not suffice")};
    } catch (const std::exception& error) {
        return SaveFailed{request.path, still_open(error.what())};
    }
}

}  // namespace rinceau
