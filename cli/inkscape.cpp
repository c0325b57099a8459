// rinceau inkscape: what the Inkscape extension calls: a document and its selected ids -> the changed document.

#include "analyzer/analyze.h"
#include "cli/exit_status.h"
#include "cli/files.h"
#include "cli/messages.h"
#include "cli/number_range.h"
#include "cli/rules_text.h"
#include "cli/verbs.h"
#include "exports/svg_clones.h"
#include "lsystem/grammar_text.h"
#include "scene/svg_replacement.h"

namespace rinceau {
namespace {

enum class InkscapeCommand : unsigned char { find_rules, symmetrize };

struct InkscapeOptions {
    std::string document;
    std::vector<std::string> ids;
    std::vector<std::string> nodes;  ///< nodes of paths that are selected: of no use here
    std::string page;                ///< of the dialog that was open
    InkscapeCommand command = InkscapeCommand::find_rules;
    AnalyzeOptions analyze;
};

/// A message for a person in Inkscape, who has no command line before them.
constexpr const char* nothing_selected =
    "There is nothing to work on: the selection is empty, locked or hidden, or draws nothing that Rinceau understands.";
constexpr const char* no_rules = "No rule was found: no element repeats regularly. The drawing stays as it is.";
constexpr const char* no_rules_cure =
    "A larger tolerance finds rules in less regular drawings; objects that repeat must have the same shape and style.";

/// The rules that stand with the selection, as long as they draw what it shows; else nothing: it was changed by hand.
std::optional<Grammar> kept_grammar(const SvgReplacement& drawing) {
    if (drawing.rules().empty()) return std::nullopt;
    Grammar grammar = parse_grammar(drawing.rules(), "rules of the group");
    if (!verify(grammar, drawing.scene()).passed) return std::nullopt;
    return grammar;
}

std::optional<Grammar> found_grammar(const SvgReplacement& drawing, AnalyzeOptions options, bool symmetrize) {
    options.symmetrize = symmetrize;
    Analysis analysis = analyze(drawing.scene(), options);
    if (analysis.report.productions.empty()) return std::nullopt;
    return std::move(analysis.grammar);
}

std::optional<Grammar> wanted_grammar(const SvgReplacement& drawing, const InkscapeOptions& options) {
    switch (options.command) {
        case InkscapeCommand::find_rules:
            return found_grammar(drawing, options.analyze, false);
        case InkscapeCommand::symmetrize:
            return found_grammar(drawing, options.analyze, true);
    }
    return std::nullopt;
}

int run_inkscape(const InkscapeOptions& options) {
    const SvgReplacement drawing(read_input(options.document), options.ids, {.file_name = "document"});
    if (drawing.scene().elements.empty()) {
        say(nothing_selected);
        return exit_status::input_at_fault;
    }
    const std::optional<Grammar> grammar = wanted_grammar(drawing, options);
    if (!grammar) {
        // without any output Inkscape leaves the document, and its history, alone
        say(no_rules);
        say(no_rules_cure);
        return exit_status::input_at_fault;
    }
    if (drawing.overtaken() > 0)
        say(std::to_string(drawing.overtaken()) +
            " objects that were not selected lay above selected ones; they lie below them now, as after Object > Group.");
    write_output("", drawing.document_with({to_svg_clones(*grammar).bytes, to_text(*grammar), "Rinceau"}));
    return exit_status::done;
}

}  // namespace

void add_inkscape(CLI::App& program, Job& job) {
    const auto [verb, options] =
        add_verb<InkscapeOptions>(program, job, "inkscape", "Work on the selection of an Inkscape document",
                                  "rinceau inkscape --command find_rules --id path1 --id path2 drawing.svg > changed.svg",
                                  run_inkscape);
    verb->add_option("DOCUMENT", options->document, "The document (.svg)")->required();
    verb->add_option("--id", options->ids, "A selected object; without any, everything that is neither locked nor hidden")
        ->allow_extra_args(false)
        ->type_name("ID");
    const std::map<std::string, InkscapeCommand> commands{{"find_rules", InkscapeCommand::find_rules},
                                                          {"symmetrize", InkscapeCommand::symmetrize}};
    verb->add_option("--command", options->command, "What to do: find_rules or symmetrize")
        ->transform(CLI::CheckedTransformer(commands).description(""))
        ->type_name("COMMAND");
    constexpr double largest_tolerance = 1;  // an element's own size
    verb->add_option("--tolerance", options->analyze.tolerance,
                     "Largest deviation of a repetition, in element sizes; 0 tries several and keeps the shortest rules")
        ->check(number_between(0, largest_tolerance))
        ->capture_default_str()
        ->type_name("T");
    // what Inkscape passes besides
    verb->add_option("--selected-nodes", options->nodes)->allow_extra_args(false)->group("");
    verb->add_option("--page", options->page)->group("");
}

}  // namespace rinceau
