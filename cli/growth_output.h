#pragma once
// What has grown, as a picture or as a grammar.

#include <string>
#include <vector>

#include "growth/figures.h"

namespace rinceau {

/// Throws CLI::ValidationError naming -o, or OutputError, if what grows cannot be written to `output`: .svg, .png and .pdf
/// are pictures, .lsys and .json grammars; standard output gets SVG.
void expect_growth_output(const std::string& output);

/// What is placed, on a canvas, by the output's ending. `width` of a .png in pixels, 0 = the canvas's own.
void write_growth(const FiguredDrawing& drawing, const std::vector<PlacedFigure>& placed, const Box& canvas,
                  const std::string& output, int width = 0);

}  // namespace rinceau
