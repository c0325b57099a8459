#include "cli/edit_output.h"

#include "cli/derive_options.h"
#include "cli/files.h"
#include "cli/messages.h"
#include "cli/progress_bar.h"
#include "lsystem/check_edit.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "lsystem/to_scene.h"
#include "scene/svg_raster.h"

namespace rinceau {

namespace {

std::string output_bytes(const Grammar& grammar, const EditFiles& files) {
    const FileFormat format = format_of(files.output, FileFormat::lsys);
    if (format == FileFormat::lsys) return to_text(grammar);
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

Grammar read_for_edit(const EditFiles& files) {
    const FileFormat format = format_of(files.output, FileFormat::lsys);
    if (format == FileFormat::unknown || format == FileFormat::json || format == FileFormat::csv)
        throw CLI::ValidationError("-o",
                                   "expected a name that ends in .lsys, .svg, .png or .pdf, found '" + files.output + "'");
    expect_writable(files.output);
    return parse_grammar(read_input(files.input), input_label(files.input));
}

void write_edit(const Grammar& before, EditResult edit, const EditFiles& files) {
    ProgressBar bar;
    const EditResult checked = checked_edit(before, std::move(edit), {.derive = files.derive}, bar.callback());
    const std::string bytes = output_bytes(checked.grammar, files);
    write_output(files.output, bytes);
    for (const std::string& change : checked.changes) say(change);
    if (checked.changes.empty()) say("nothing is different");
}

}  // namespace rinceau
