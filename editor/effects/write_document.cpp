#include "editor/effects/write_document.h"

#include <cstring>
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

}  // namespace

std::string with_cure(const std::string& message) {
    const auto is = [&](int error) { return message.find(std::strerror(error)) != std::string::npos; };
    if (is(ENOSPC)) return message + ". Make room on the disk, or save elsewhere; the document stays open, unsaved";
    if (is(EDQUOT) || is(EFBIG)) return message + ". Save elsewhere; the document stays open, unsaved";
    if (is(EACCES) || is(EPERM) || is(EROFS))
        return message + ". Save under another name or in another folder; the document stays open, unsaved";
    if (is(ENOENT) || is(ENOTDIR))
        return message + ". Its folder is gone: save in another folder; the document stays open, unsaved";
    return message + ". The document stays open, unsaved";
}

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
        return SaveFailed{request.path, with_cure(request.path + ": the memory does not suffice")};
    } catch (const std::exception& error) {
        return SaveFailed{request.path, with_cure(error.what())};
    }
}

}  // namespace rinceau
