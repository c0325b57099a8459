#include "cli/growth_input.h"

#include <filesystem>

#include "analyzer/analyze.h"
#include "cli/messages.h"
#include "cli/progress_bar.h"
#include "files/files.h"
#include "scene/svg_read.h"

namespace rinceau {
namespace {

void add_warnings(const std::vector<std::string>& warnings, std::vector<std::string>& said) {
    for (const std::string& warning : warnings) say("warning: " + warning);
    said.insert(said.end(), warnings.begin(), warnings.end());
}

AnalyzedInput analyzed(const std::string& bytes, const std::string& label, int threads) {
    const SvgReadResult drawing = read_svg(bytes, {.file_name = label});
    std::vector<std::string> warnings;
    for (const Warning& warning : drawing.warnings) warnings.push_back(located(warning.place, warning.message));
    AnalyzedInput input;
    add_warnings(warnings, input.warnings);
    ProgressBar bar;
    AnalyzeOptions options;
    options.threads = threads;
    Analysis analysis = analyze(drawing.scene, options, bar.callback());
    add_warnings(analysis.report.warnings, input.warnings);
    input.grammar = std::move(analysis.grammar);
    return input;
}

}  // namespace

AnalyzedInput read_rules(const std::string& name, const std::string& bytes, int threads) {
    if (looks_like_drawing(bytes)) return analyzed(bytes, input_label(name), threads);
    return {read_grammar(name, bytes), {}};
}

GrowthInput read_growth_input(const std::string& name, const FigureOptions& options, int threads) {
    GrowthInput input{.label = input_label(name)};
    const std::string bytes = read_input(name);
    AnalyzedInput rules = read_rules(name, bytes, threads);
    input.warnings = std::move(rules.warnings);
    ProgressBar bar;
    input.drawing = figures_of(rules.grammar, options, bar.callback());
    add_warnings(input.drawing.warnings, input.warnings);
    return input;
}

std::function<std::string(const std::string& named)> files_beside(const std::string& name) {
    return [folder = std::filesystem::path(name).parent_path()](const std::string& named) {
        return read_input((folder / named).string());  // a whole path takes the folder's place
    };
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
