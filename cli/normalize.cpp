// rinceau normalize: the drawing as the importer understood it.

#include "cli/exit_status.h"
#include "files/files.h"
#include "files/output_file.h"
#include "cli/messages.h"
#include "cli/verbs.h"
#include "scene/svg_read.h"
#include "scene/svg_write.h"

namespace rinceau {
namespace {

struct NormalizeOptions {
    std::string input;
    std::string output;
};

int normalize(const NormalizeOptions& options) {
    if (format_of(options.output, FileFormat::svg) != FileFormat::svg)
        throw CLI::ValidationError("-o", "expected a name that ends in .svg, found '" + options.output + "'");
    expect_writable(options.output);

    const SvgReadResult drawing = read_svg(read_input(options.input), {.file_name = input_label(options.input)});
    say_warnings(drawing.warnings);
    write_output(options.output, write_svg(drawing.scene));
    return exit_status::done;
}

}  // namespace

void add_normalize(CLI::App& program, Job& job) {
    const auto [verb, options] = add_verb<NormalizeOptions>(
        program, job, "normalize", "Write a drawing as it was understood, with a warning for each thing that was not",
        "rinceau normalize samples/rosette.svg -o plain.svg", normalize);
    verb->add_option("ART", options->input, "The drawing (.svg, .svgz, or - for standard input)")->required();
    verb->add_option("-o,--output", options->output, "Where to write the plain SVG; without it, to standard output")
        ->type_name("FILE");
}

}  // namespace rinceau
