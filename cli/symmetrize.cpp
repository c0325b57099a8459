// rinceau symmetrize: the regular drawing behind an irregular one.

#include "lsystem/symmetrize.h"

#include "analyzer/analyze.h"
#include "cli/edit_output.h"
#include "cli/exit_status.h"
#include "cli/messages.h"
#include "cli/progress_bar.h"
#include "cli/rules_text.h"
#include "cli/verbs.h"
#include "files/files.h"
#include "lsystem/grammar_text.h"
#include "scene/svg_read.h"

namespace rinceau {
namespace {

struct SymmetrizeVerbOptions {
    EditFiles files;
    SymmetrizeOptions symmetrize;
};

Grammar regular_layout(const std::string& bytes, const EditFiles& files) {
    const std::string label = input_label(files.input);
    const SvgReadResult drawing = read_svg(bytes, {.file_name = label});
    say_warnings(drawing.warnings);
    ProgressBar bar;
    AnalyzeOptions options;
    options.symmetrize = true;
    const Analysis analysis = analyze(drawing.scene, options, bar.callback());
    for (const std::string& warning : analysis.report.warnings) say("warning: " + warning);
    if (!analysis.report.check.passed)
        throw InputError({label}, "the layout that was found is not that of the drawing, and is not written: " +
                                      analysis.report.check.summary);
    say(summary_line(analysis.report));
    return analysis.grammar;
}

int run_symmetrize(const SymmetrizeVerbOptions& options) {
    expect_edit_output(options.files);
    const std::string bytes = read_input(options.files.input);
    if (looks_like_drawing(bytes)) {
        write_grammar_or_picture(regular_layout(bytes, options.files), options.files);
        return exit_status::done;
    }
    const Grammar grammar = parse_grammar(bytes, input_label(options.files.input));
    write_edit(grammar, symmetrize(grammar, options.symmetrize), options.files);
    return exit_status::done;
}

}  // namespace

void add_symmetrize(CLI::App& program, Job& job) {
    const auto [verb, options] = add_verb<SymmetrizeVerbOptions>(
        program, job, "symmetrize", "Make the regular drawing behind an irregular drawing or grammar",
        "rinceau symmetrize samples/facade.svg -o regular.svg", run_symmetrize);
    add_edit_options(*verb, options->files);
    verb->get_option("RULES")->description("The grammar (.lsys) or drawing (.svg, .svgz), or - for standard input");
    verb->add_option("--tolerance", options->symmetrize.tolerance,
                     "How near is nearly regular in the rules of a grammar: times what a hand misses by")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str()
        ->type_name("T");
    verb->add_flag("--all", options->symmetrize.all_exceptions,
                   "Drop all exceptions of a grammar: also holes, and what stands in for something else");
}

}  // namespace rinceau
