#pragma once
// What growth begins with: a drawing, whose rules are found first, or a grammar.

#include <functional>
#include <string>
#include <vector>

#include "growth/figures.h"
#include "growth/strokes.h"

namespace rinceau {

struct GrowthInput {
    std::string label;
    FiguredDrawing drawing;
    std::vector<std::string> warnings;  ///< of reading, of the analysis and of the figures; they were said
};

/// Rules as they were read, or found in a drawing.
struct AnalyzedInput {
    Grammar grammar;
    std::vector<std::string> warnings;  ///< they were said
};

/// The rules of the bytes of the file `name`: a drawing, which is analysed, or a grammar. Says warnings. Throws as
/// read_svg(), read_grammar() and analyze().
AnalyzedInput read_rules(const std::string& name, const std::string& bytes, int threads);

/// Reads `name` (.svg, .svgz, .lsys, .json, or - for standard input). Says warnings. Throws as read_input(), read_svg(),
/// read_grammar(), analyze() and figures_of().
GrowthInput read_growth_input(const std::string& name, const FigureOptions& options, int threads);

/// Reads files by the names that the file `name` gives them: beside it, unless they are whole paths. Throws as read_input().
std::function<std::string(const std::string& named)> files_beside(const std::string& name);

/// A drawing of lines or areas that guide growth. Says warnings. Throws as read_input() and read_svg().
Scene read_guide(const std::string& name);

/// How far lines may be from the curves that they stand for, in a guide: scene length.
double guide_deviation(const Scene& guide);

}  // namespace rinceau
