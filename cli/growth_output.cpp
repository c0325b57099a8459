#include "cli/growth_output.h"

#include <algorithm>
#include <array>

#include <CLI/Error.hpp>

#include "exports/json_grammar.h"
#include "files/files.h"
#include "files/output_file.h"
#include "lsystem/grammar_text.h"
#include "lsystem/to_scene.h"
#include "scene/svg_raster.h"

namespace rinceau {
namespace {

std::string svg_of(const FiguredDrawing& drawing, const std::vector<PlacedFigure>& placed, const Box& canvas) {
    Grammar looks;  // what placements name
    looks.title = drawing.grammar.title;
    looks.canvas = canvas;
    looks.styles = drawing.grammar.styles;
    looks.terminals = drawing.grammar.terminals;
    return grammar_svg(looks, placements_of(drawing, placed));
}

std::string output_bytes(const FiguredDrawing& drawing, const std::vector<PlacedFigure>& placed, const Box& canvas,
                         FileFormat format, int width) {
    switch (format) {
        case FileFormat::lsys:
            return to_text(grammar_of(drawing, placed, canvas));
        case FileFormat::json:
            return to_json(grammar_of(drawing, placed, canvas)).bytes;
        case FileFormat::png:
            return svg_to_png(svg_of(drawing, placed, canvas), width);
        case FileFormat::pdf:
            return svg_to_pdf(svg_of(drawing, placed, canvas));
        default:
            return svg_of(drawing, placed, canvas);
    }
}

}  // namespace

void expect_growth_output(const std::string& output) {
    const FileFormat format = format_of(output, FileFormat::svg);
    constexpr std::array<FileFormat, 5> written{FileFormat::svg, FileFormat::png, FileFormat::pdf, FileFormat::lsys,
                                                FileFormat::json};
    if (std::ranges::find(written, format) == written.end())
        throw CLI::ValidationError("-o",
                                   "expected a name that ends in .svg, .png, .pdf, .lsys or .json, found '" + output + "'");
    expect_writable(output);
}

void write_growth(const FiguredDrawing& drawing, const std::vector<PlacedFigure>& placed, const Box& canvas,
                  const std::string& output, int width) {
    write_output(output, output_bytes(drawing, placed, canvas, format_of(output, FileFormat::svg), width));
}

}  // namespace rinceau
