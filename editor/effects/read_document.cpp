#include "editor/effects/read_document.h"

#include <memory>
#include <utility>

#include "editor/effects/folders.h"
#include "editor/model/file_kind.h"
#include "editor/model/project.h"
#include "exports/json_grammar.h"
#include "files/files.h"
#include "lsystem/flat_grammar.h"
#include "lsystem/grammar_text.h"
#include "lsystem/resolve_uses.h"
#include "scene/svg_read.h"

namespace rinceau {
namespace {

/// By the name, and where that says nothing by how the content begins: a drawing is XML, or packed, or UTF-16.
bool holds_drawing(const std::string& path, std::string_view bytes) {
    const FileKind kind = kind_of_name(path);
    if (kind != FileKind::other) return kind == FileKind::drawing;
    const auto first = bytes.find_first_not_of(" \t\r\n\xef\xbb\xbf");
    return bytes.starts_with("\x1f\x8b") || bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff") ||
           (first != std::string_view::npos && bytes[first] == '<');
}

FileOpened drawing_document(const std::string& path, std::string_view bytes) {
    SvgReadResult read = read_svg(bytes, {.file_name = path});
    FileOpened opened{.path = path, .document = with_grammar(empty_document(), flat_grammar(read.scene)), .analyse = true};
    opened.document.drawing = std::make_shared<const Scene>(std::move(read.scene));
    for (const Warning& warning : read.warnings) opened.warnings.push_back(located(warning.place, warning.message));
    return opened;
}

FileOpened project_document(const std::string& path, std::string_view bytes) {
    Project project = parse_project(bytes, absolute_path(path));
    return {.path = path, .document = std::move(project.document), .view = project.view};
}

FileOpened grammar_document(const std::string& path, std::string_view bytes) {
    FileOpened opened{.path = path, .document = empty_document()};
    auto used = std::make_shared<UsedFiles>();
    const std::string absolute = absolute_path(path);
    auto grammar = std::make_shared<const Grammar>(looks_like_json(bytes) ? parse_json_grammar(bytes, absolute)
                                                                          : parse_grammar(bytes, absolute));
    opened.document.grammar = grammar;
    opened.document.resolved = grammar;
    if (!grammar->uses.empty()) {
        const auto load = [&](const std::string& name) { return (*used)[name] = read_grammar_text(name); };
        opened.document.resolved = std::make_shared<const Grammar>(resolve_uses(*grammar, load));
        opened.document.used = std::move(used);
    }
    return opened;
}

FileOpened open_bytes(const std::string& path, std::string_view bytes) {
    if (holds_drawing(path, bytes)) return drawing_document(path, bytes);
    const bool project = kind_of_name(path) == FileKind::project || (looks_like_json(bytes) && looks_like_project(bytes));
    return project ? project_document(path, bytes) : grammar_document(path, bytes);
}

}  // namespace

FileOpened read_document(const std::string& path) {
    const std::optional<FileStamp> stamp = stamp_of(path);  // before reading: a change in between is noticed when saving
    const std::string bytes = read_input(path);
    FileOpened opened = open_bytes(path, bytes);
    opened.stamp = stamp;
    opened.absolute = absolute_path(path);
    return opened;
}

}  // namespace rinceau
