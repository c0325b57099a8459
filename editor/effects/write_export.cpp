#include "editor/effects/write_export.h"

#include <filesystem>

#include "exports/export_formats.h"
#include "files/files.h"
#include "lsystem/grammar_text.h"
#include "lsystem/to_scene.h"
#include "scene/svg_raster.h"

namespace rinceau {
namespace {

std::string picture_bytes(const Document& document, const std::string& format) {
    std::string svg;
    write_grammar_svg(*document.resolved, {.derive = document.derive}, {}, [&](std::string_view piece) { svg += piece; });
    if (format == "png") return svg_to_png(svg);
    if (format == "pdf") return svg_to_pdf(svg);
    return svg;
}

}  // namespace

std::vector<std::string> write_export(const Document& document, const std::string& path, const std::string& format) {
    if (format == "picture-svg" || format == "png" || format == "pdf") {
        write_output(path, picture_bytes(document, format));
        return {};
    }
    const ExportFormat* target = find_export_format(format);
    if (target == nullptr) throw InputError({path}, "there is no format '" + format + "'");
    const Grammar& grammar = target->keeps_uses ? *document.grammar : *document.resolved;
    const Export exported = target->write(grammar, {.derive = document.derive});
    write_output(path, exported.bytes);
    for (const CompanionFile& companion : exported.companions)
        write_output(std::filesystem::path(path).replace_extension(companion.ending).string(), companion.bytes);
    return exported.notes;
}

}  // namespace rinceau
