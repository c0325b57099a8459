// rinceau render: grammar -> drawing.

#include <map>

#include "cli/derive_options.h"
#include "cli/exit_status.h"
#include "files/files.h"
#include "files/output_file.h"
#include "cli/progress_bar.h"
#include "cli/verbs.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "lsystem/to_scene.h"
#include "scene/svg_raster.h"

namespace rinceau {
namespace {

struct RenderOptions {
    std::string input;
    std::string output;
    int width = 0;  // pixels; 0 = the picture's own
    ColorBy color_by = ColorBy::none;
    DeriveOptions derive;
};

FileFormat picture_format(const RenderOptions& options) {
    const FileFormat format = format_of(options.output, FileFormat::svg);
    if (format != FileFormat::svg && format != FileFormat::png && format != FileFormat::pdf)
        throw CLI::ValidationError("-o", "expected a name that ends in .svg, .png or .pdf, found '" + options.output + "'");
    if (options.width != 0 && format != FileFormat::png) throw CLI::ValidationError("--width", "is for .png only");
    return format;
}

void draw_svg(const Grammar& grammar, const RenderOptions& options, const TextSink& sink) {
    ProgressBar bar;
    // A level is the length of an address.
    const bool addresses = options.color_by == ColorBy::level;
    write_grammar_svg(grammar, {.derive = options.derive, .addresses = addresses}, {.color_by = options.color_by}, sink,
                      bar.callback());
}

std::string rasterized(const Grammar& grammar, const RenderOptions& options, FileFormat format) {
    std::string svg;
    draw_svg(grammar, options, [&](std::string_view piece) { svg += piece; });
    return format == FileFormat::png ? svg_to_png(svg, options.width) : svg_to_pdf(svg);
}

int render(const RenderOptions& options) {
    const FileFormat format = picture_format(options);
    expect_writable(options.output);
    const Grammar grammar = read_grammar(options.input);
    OutputFile output(options.output);
    if (format == FileFormat::svg) {
        draw_svg(grammar, options, [&](std::string_view piece) { output.write(piece); });
    } else {
        output.write(rasterized(grammar, options, format));
    }
    output.finish();
    return exit_status::done;
}

}  // namespace

void add_render(CLI::App& program, Job& job) {
    const auto [verb, options] =
        add_verb<RenderOptions>(program, job, "render", "Draw a grammar as .svg, .png or .pdf",
                                "rinceau render samples/rosette.lsys -o rosette.png --width 900", render);
    verb->add_option("RULES", options->input, "The grammar (.lsys, or - for standard input)")->required();
    verb->add_option("-o,--output", options->output,
                     "The picture (.svg, .png or .pdf, by its ending); without it, SVG to standard output")
        ->type_name("FILE");
    constexpr int widest_png = 32767;  // librsvg's and cairo's limit
    verb->add_option("--width", options->width, "Width of a .png in pixels; without it, the drawing's own")
        ->check(CLI::Range(1, widest_png))
        ->type_name("W");
    const std::map<std::string, ColorBy> colorings{
        {"rule", ColorBy::rule}, {"terminal", ColorBy::terminal}, {"level", ColorBy::level}};
    verb->add_option("--color-by", options->color_by, "Paint by what made each thing: rule, terminal or level")
        ->transform(CLI::CheckedTransformer(colorings).description(""))
        ->type_name("rule|terminal|level");
    add_derive_options(*verb, options->derive);
}

}  // namespace rinceau
