#include "editor/effects/write_export.h"

#include <filesystem>
#include <utility>

#include "editor/model/export_target.h"
#include "exports/export_formats.h"
#include "files/files.h"
#include "files/output_file.h"
#include "lsystem/to_scene.h"
#include "scene/svg_raster.h"

namespace rinceau {
namespace {

/// Letters, digits and underscores of the file's name.
std::string export_name(const std::string& path) {
    std::string name;
    for (const char c : std::filesystem::path(path).stem().string()) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        name += plain ? c : '_';
    }
    const bool starts_with_letter = !name.empty() && (name.front() < '0' || name.front() > '9') && name.front() != '_';
    return starts_with_letter ? name : "rinceau" + name;
}

std::string picture_bytes(const Document& document, const ExportFile& what, const Progress& progress) {
    std::string svg;
    write_grammar_svg(
        *document.resolved, {.derive = document.derive}, {}, [&](std::string_view piece) { svg += piece; }, progress);
    report(progress, "paint", 0);
    if (what.format == "png") return svg_to_png(svg, what.choices.width);
    if (what.format == "pdf") return svg_to_pdf(svg);
    return svg;
}

}  // namespace

ExportedFiles make_export(const Document& document, const ExportFile& what, const Progress& progress) {
    if (find_export_target(what.format).picture) return {{{what.path, picture_bytes(document, what, progress)}}, {}};
    const ExportFormat* format = find_export_format(what.format);
    if (format == nullptr) throw InputError({what.path}, "there is no format '" + what.format + "'");
    const Grammar& grammar = format->keeps_uses ? *document.grammar : *document.resolved;
    report(progress, "write", 0);
    Export exported = format->write(
        grammar, {.derive = document.derive, .name = export_name(what.path), .live_random = what.choices.live_random});
    ExportedFiles made{{}, std::move(exported.notes)};
    for (CompanionFile& companion : exported.companions)
        made.files.push_back(
            {std::filesystem::path(what.path).replace_extension(companion.ending).string(), std::move(companion.bytes)});
    made.files.push_back({what.path, std::move(exported.bytes)});
    return made;
}

std::vector<std::string> files_to_replace(const ExportedFiles& made) {
    std::vector<std::string> there;
    for (const ExportedFiles::File& file : made.files) {
        std::error_code ignored;
        if (std::filesystem::exists(file.path, ignored)) there.push_back(file.path);
    }
    return there;
}

void write_export(const ExportedFiles& made) {
    for (const ExportedFiles::File& file : made.files) expect_writable(file.path);
    for (const ExportedFiles::File& file : made.files) write_output(file.path, file.bytes);
}

}  // namespace rinceau
