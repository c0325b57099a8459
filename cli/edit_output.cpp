#include "cli/edit_output.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "cli/derive_options.h"
#include "files/files.h"
#include "files/output_file.h"
#include "cli/messages.h"
#include "cli/progress_bar.h"
#include "lsystem/check_edit.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "lsystem/resolve_uses.h"
#include "lsystem/to_scene.h"
#include "scene/svg_raster.h"

namespace rinceau {

namespace {

/// With all that it uses of other files.
Grammar for_drawing(const Grammar& grammar) { return resolve_uses(grammar, read_input); }

/// A grammar that is written into another folder still uses the same files.
Grammar moved_beside(Grammar grammar, const std::string& output) {
    if (output.empty() || output == "-") return grammar;
    const auto folder_of = [](const std::string& name) {
        return std::filesystem::absolute(name).lexically_normal().parent_path();
    };
    for (Use& use : grammar.uses) {
        const auto from = folder_of(use.place.file);
        const auto to = folder_of(output);
        if (from == to || std::filesystem::path(use.file).is_absolute()) continue;
        use.file = (from / use.file).lexically_normal().lexically_relative(to).generic_string();
    }
    return grammar;
}

std::string output_bytes(const Grammar& edited, const EditFiles& files) {
    const FileFormat format = format_of(files.output, FileFormat::lsys);
    if (format == FileFormat::lsys) return to_text(moved_beside(edited, files.output));
    const Grammar grammar = for_drawing(edited);
    const std::string svg = grammar_svg(grammar, interpret(grammar, {.derive = files.derive}));
    if (format == FileFormat::png) return svg_to_png(svg, 0);
    return format == FileFormat::pdf ? svg_to_pdf(svg) : svg;
}

}  // namespace

void add_edit_options(CLI::App& verb, EditFiles& files) {
    verb.add_option("RULES", files.input, "The grammar (.lsys, or - for standard input)")->required();
    verb.add_option("-o,--output", files.output,
                    "Where to write the edited grammar (.lsys; may be RULES itself), or its picture (.svg, .png, .pdf); "
                    "without it, the grammar to standard output")
        ->type_name("FILE");
}

void expect_edit_output(const EditFiles& files) {
    const FileFormat format = format_of(files.output, FileFormat::lsys);
    constexpr std::array<FileFormat, 4> written{FileFormat::lsys, FileFormat::svg, FileFormat::png, FileFormat::pdf};
    if (std::ranges::find(written, format) == written.end())
        throw CLI::ValidationError("-o",
                                   "expected a name that ends in .lsys, .svg, .png or .pdf, found '" + files.output + "'");
    expect_writable(files.output);
}

void write_grammar_or_picture(const Grammar& grammar, const EditFiles& files) {
    write_output(files.output, output_bytes(grammar, files));
}

Grammar read_for_edit(const EditFiles& files) {
    expect_edit_output(files);
    return read_grammar_as_written(files.input);
}

void write_edit(const Grammar& before, EditResult edit, const EditFiles& files) {
    ProgressBar bar;
    const EditResult checked =
        checked_edit(before, std::move(edit), {.derive = files.derive, .for_drawing = for_drawing}, bar.callback());
    write_grammar_or_picture(checked.grammar, files);
    for (const std::string& change : checked.changes) say(change);
    if (checked.changes.empty()) say("nothing is different");
}

}  // namespace rinceau
