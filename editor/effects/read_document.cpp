#include "editor/effects/read_document.h"

#include <memory>
#include <utility>

#include "files/files.h"
#include "lsystem/resolve_uses.h"
#include "scene/svg_read.h"

namespace rinceau {
namespace {

FileOpened drawing_document(const std::string& path) {
    SvgReadResult read = read_svg(read_input(path), {.file_name = path});
    FileOpened opened{path, empty_document(), {}};
    auto grammar = std::make_shared<Grammar>();
    grammar->canvas = read.scene.viewport;
    grammar->sized = read.scene.sized;
    opened.document.grammar = opened.document.resolved = std::move(grammar);
    opened.document.drawing = std::make_shared<const Scene>(std::move(read.scene));
    for (const Warning& warning : read.warnings) opened.warnings.push_back(located(warning.place, warning.message));
    return opened;
}

FileOpened grammar_document(const std::string& path) {
    FileOpened opened{path, empty_document(), {}};
    auto used = std::make_shared<UsedFiles>();
    auto grammar = std::make_shared<const Grammar>(read_grammar_as_written(path));
    opened.document.grammar = grammar;
    opened.document.resolved = grammar;
    if (!grammar->uses.empty()) {
        const auto load = [&](const std::string& name) { return (*used)[name] = read_grammar_text(name); };
        opened.document.resolved = std::make_shared<const Grammar>(resolve_uses(*grammar, load));
        opened.document.used = std::move(used);
    }
    return opened;
}

}  // namespace

FileOpened read_document(const std::string& path) {
    return format_of(path, FileFormat::unknown) == FileFormat::svg ? drawing_document(path) : grammar_document(path);
}

}  // namespace rinceau
