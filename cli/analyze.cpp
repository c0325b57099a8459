// rinceau analyze: drawing -> grammar.

#include "analyzer/analyze.h"

#include <chrono>

#include "cli/analysis_check.h"
#include "cli/batch.h"
#include "cli/exit_status.h"
#include "cli/messages.h"
#include "cli/number_range.h"
#include "cli/progress_bar.h"
#include "cli/report_json.h"
#include "cli/rules_text.h"
#include "cli/spaces_output.h"
#include "cli/verbs.h"
#include "cli/weights_option.h"
#include "files/files.h"
#include "files/output_file.h"
#include "lsystem/grammar_text.h"
#include "scene/svg_read.h"

namespace rinceau {
namespace {

struct AnalyzeVerbOptions {
    std::vector<std::string> inputs;
    std::string output;
    std::vector<std::string> reports;
    std::string spaces;
    bool print = false;
    AnalyzeOptions analyze;
    BatchOptions batch;
};

const std::string& input_of(const AnalyzeVerbOptions& options) { return options.inputs.front(); }

std::string report_of(const AnalyzeVerbOptions& options) { return options.reports.empty() ? "" : options.reports.front(); }

void expect_outputs(const AnalyzeVerbOptions& options) {
    if (format_of(options.output, FileFormat::lsys) != FileFormat::lsys)
        throw CLI::ValidationError("-o", "expected a name that ends in .lsys, found '" + options.output + "'");
    if (options.reports.size() > 1) throw CLI::ValidationError("--report", "expected one name for one drawing");
    const std::string report = report_of(options);
    if (format_of(report, FileFormat::json) != FileFormat::json)
        throw CLI::ValidationError("--report", "expected a name that ends in .json, found '" + report + "'");
    if (options.print && options.output == "-")
        throw CLI::ValidationError("--print", "writes to standard output, and so does '-o -'");
    const FileFormat spaces = format_of(options.spaces, FileFormat::csv);
    if (spaces != FileFormat::csv && spaces != FileFormat::svg)
        throw CLI::ValidationError("--spaces", "expected a name that ends in .csv or .svg, found '" + options.spaces + "'");
    for (const std::string& name : {options.output, report, options.spaces}) expect_writable(name);
}

Analysis analyze_scene(const Scene& scene, const AnalyzeVerbOptions& options) {
    ProgressBar bar;
    return analyze(scene, options.analyze, bar.callback());
}

void write_spaces(const Scene& scene, const AnalyzeVerbOptions& options) {
    if (options.spaces.empty()) return;
    const FileFormat format = format_of(options.spaces, FileFormat::csv);
    write_output(options.spaces, spaces_output(scene, options.analyze.similarity, format));
}

void write_results(const Analysis& analysis, const ReportContext& context, const AnalyzeVerbOptions& options) {
    if (const std::string report = report_of(options); !report.empty())
        write_output(report, report_json(analysis.report, context));
    if (!options.output.empty()) write_output(options.output, to_text(analysis.grammar));
    if (options.output.empty() || options.print)
        write_output("", rules_text(analysis));
    else
        say(summary_line(analysis.report));
}

int analyze_one(const AnalyzeVerbOptions& options) {
    using Clock = std::chrono::steady_clock;
    const auto seconds_since = [](Clock::time_point start) {
        return std::chrono::duration<double>(Clock::now() - start).count();
    };
    expect_outputs(options);

    const auto start = Clock::now();
    const std::string label = input_label(input_of(options));
    expect_no_shape_grammar(input_of(options));
    const SvgReadResult drawing = read_svg(read_input(input_of(options)), {.file_name = label});
    ReportContext context{.input = input_of(options), .warnings = drawing.warnings, .import_seconds = seconds_since(start)};
    say_warnings(drawing.warnings);

    const Analysis analysis = analyze_scene(drawing.scene, options);
    for (const std::string& warning : analysis.report.warnings) say("warning: " + warning);
    expect_passed(analysis.report.check, label);

    context.total_seconds = seconds_since(start);
    write_spaces(drawing.scene, options);
    write_results(analysis, context, options);
    return exit_status::done;
}

int run_analyze(const AnalyzeVerbOptions& options) {
    if (!is_batch(options.inputs, options.output, options.batch)) return analyze_one(options);
    if (options.print) throw CLI::ValidationError("--print", "is for one drawing");
    if (!options.spaces.empty()) throw CLI::ValidationError("--spaces", "is for one drawing");
    return run_batch(options.inputs, options.output, options.reports, options.analyze, options.batch);
}

void add_recognition_options(CLI::App& verb, AnalyzeVerbOptions& options) {
    constexpr double largest_tolerance = 1;  // an element's own size
    constexpr double least_similarity = 1e-6;
    constexpr double largest_similarity = 0.2;
    constexpr int most_threads = 1024;
    verb.add_option("--tolerance", options.analyze.tolerance,
                    "Largest deviation of a repetition, in element sizes; 0 tries several and keeps the shortest grammar")
        ->check(number_between(0, largest_tolerance))
        ->capture_default_str()
        ->type_name("T");
    verb.add_option("--similarity", options.analyze.similarity.tolerance,
                    "Largest distance of two outlines that count as equal, in their rms radii")
        ->check(number_between(least_similarity, largest_similarity))
        ->capture_default_str()
        ->type_name("S");
    verb.add_option_function<std::string>(
            "--weights", [&options](const std::string& text) { options.analyze.weights = parse_weights(text); },
            "What is preferred, 0 to 4, 1 = neutral: n many repetitions, h near elements, phi small deviations, l long "
            "sequences")
        ->type_name("n=..,h=..,phi=..,l=..");
    verb.add_option_function<std::string>(
            "--objective", [&options](const std::string& text) { options.analyze.objective = parse_objective(text); },
            "What decides on the next rule: what it saves in bits, or the importance function of Stava et al. 2010, which "
            "joins whatever repeats")
        ->type_name("bits|paper");
    CLI::Option* symmetrize =
        verb.add_flag("--symmetrize", options.analyze.symmetrize,
                      "Draw the regular layout behind an irregular drawing; the report says how far elements moved");
    verb.add_flag("--stochastic", options.analyze.stochastic,
                  "Instead of where each element of an irregular drawing stands, write how much they scatter: every seed "
                  "draws a relative of the drawing")
        ->excludes(symmetrize);
    verb.add_option("--threads", options.analyze.threads,
                    "Threads; 0 = one per processor; the result is the same for any number")
        ->check(CLI::Range(0, most_threads))
        ->capture_default_str()
        ->type_name("N");
}

}  // namespace

void add_analyze(CLI::App& program, Job& job) {
    const auto [verb, options] =
        add_verb<AnalyzeVerbOptions>(program, job, "analyze", "Find the rules behind a drawing",
                                     "rinceau analyze samples/facade.svg -o facade.lsys --report facade.json", run_analyze);
    verb->add_option("ART", options->inputs,
                     "The drawing (.svg, .svgz, or - for standard input); or many drawings, and folders that hold them")
        ->required();
    verb->add_option("-o,--output", options->output,
                     "Where to write the grammar (.lsys); without it, the rules are printed; of many drawings: the folder")
        ->type_name("FILE");
    verb->add_flag("--print", options->print, "Print the rules for a person to read also when -o is given");
    verb->add_option(
            "--report", options->reports,
            "Where to write what was found (.json, as docs/report.schema.json says); of many drawings: a table (.csv, "
            ".json, as docs/batch_report.schema.json says) or a contact sheet in the folder (.html); given again for each "
            "of several")
        ->allow_extra_args(false)
        ->take_all()
        ->type_name("FILE");
    verb->add_option("--spaces", options->spaces,
                     "Where to write the transformation spaces: .csv a table, .svg scatter plots")
        ->type_name("FILE");
    add_recognition_options(*verb, *options);
    add_batch_options(*verb, options->batch);
}

}  // namespace rinceau
