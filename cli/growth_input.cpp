#include "cli/growth_input.h"

#include "analyzer/analyze.h"
#include "cli/messages.h"
#include "cli/progress_bar.h"
#include "files/files.h"
#include "scene/svg_read.h"

namespace rinceau {
namespace {

void add_warnings(const std::vector<std::string>& warnings, GrowthInput& input) {
    for (const std::string& warning : warnings) say("warning: " + warning);
    input.warnings.insert(input.warnings.end(), warnings.begin(), warnings.end());
}

Grammar analyzed(const std::string& bytes, int threads, GrowthInput& input) {
    const SvgReadResult drawing = read_svg(bytes, {.file_name = input.label});
    std::vector<std::string> warnings;
    for (const Warning& warning : drawing.warnings) warnings.push_back(located(warning.place, warning.message));
    add_warnings(warnings, input);
    ProgressBar bar;
    AnalyzeOptions options;
    options.threads = threads;
    Analysis analysis = analyze(drawing.scene, options, bar.callback());
    add_warnings(analysis.report.warnings, input);
    return std::move(analysis.grammar);
}

}  // namespace

GrowthInput read_growth_input(const std::string& name, const FigureOptions& options, int threads) {
    GrowthInput input{.label = input_label(name)};
    const std::string bytes = read_input(name);
    const Grammar grammar = looks_like_drawing(bytes) ? analyzed(bytes, threads, input) : read_grammar(name, bytes);
    ProgressBar bar;
    input.drawing = figures_of(grammar, options, bar.callback());
    add_warnings(input.drawing.warnings, input);
    return input;
}

Scene read_guide(const std::string& name) {
    SvgReadResult drawing = read_svg(read_input(name), {.file_name = input_label(name)});
    say_warnings(drawing.warnings);
    return std::move(drawing.scene);
}

double guide_deviation(const Scene& guide) {
    constexpr double share = 2e-4;  // of the diagonal: a fifth of a pixel of a picture 1,000 pixels wide
    return share * drawing_diagonal(guide);
}

}  // namespace rinceau
