// rinceau inkscape: what the Inkscape extension calls: a document and its selected ids -> the changed document.

#include <map>
#include <memory>

#include "analyzer/analyze.h"
#include "cli/exit_status.h"
#include "files/files.h"
#include "cli/messages.h"
#include "cli/number_range.h"
#include "cli/replacement_text.h"
#include "cli/verbs.h"
#include "exports/svg_clones.h"
#include "lsystem/check_edit.h"
#include "lsystem/edit_replace.h"
#include "lsystem/grammar_text.h"
#include "lsystem/randomize.h"
#include "scene/svg_replacement.h"

namespace rinceau {
namespace {

enum class InkscapeCommand : unsigned char { find_rules, symmetrize, randomize, replace };

struct InkscapeOptions {
    std::string document;
    std::vector<std::string> ids;
    InkscapeCommand command = InkscapeCommand::find_rules;
    AnalyzeOptions analyze;
    double angle = 0;     // degrees
    double distance = 0;  // per cent
    double scale = 0;     // per cent
    std::uint64_t seed = 1;
    std::string symbol;
    std::string with;  // a file
    std::vector<std::string> nodes;  // nodes of paths that are selected: of no use here
};

/// Nothing can be done; what() is for a person in Inkscape, who has no command line before them.
class NothingToDo : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The rules that stand with the selection, as long as they draw what it shows; else it was changed by hand.
std::optional<Grammar> kept_grammar(const SvgReplacement& drawing) {
    if (drawing.rules().empty()) return std::nullopt;
    try {
        Grammar grammar = parse_grammar(drawing.rules(), "description of the group");
        if (verify(grammar, drawing.scene()).passed) return grammar;
    } catch (const InputError&) {
        // the description was changed to something else
    }
    return std::nullopt;
}

Grammar found_grammar(const SvgReplacement& drawing, AnalyzeOptions options, bool symmetrize) {
    options.symmetrize = symmetrize;
    Analysis analysis = analyze(drawing.scene(), options);
    if (analysis.report.productions.empty())
        throw NothingToDo(
            "No rule was found: nothing repeats regularly. The drawing stays as it is.\n"
            "A larger tolerance finds rules in less regular drawings; what repeats must have the same shape and style.");
    return std::move(analysis.grammar);
}

Grammar grammar_of(const SvgReplacement& drawing, const InkscapeOptions& options) {
    std::optional<Grammar> kept = kept_grammar(drawing);
    return kept ? std::move(*kept) : found_grammar(drawing, options.analyze, false);
}

/// Noise from chance goes as it came; an uneven drawing gets the layout behind it.
Grammar symmetrized(const SvgReplacement& drawing, const InkscapeOptions& options) {
    if (const std::optional<Grammar> kept = kept_grammar(drawing)) {
        Grammar even = without_noise(*kept);
        if (to_text(even) != to_text(*kept)) return even;
    }
    return found_grammar(drawing, options.analyze, true);
}

Grammar randomized(const SvgReplacement& drawing, const InkscapeOptions& options) {
    constexpr double percent = 0.01;
    const RandomizeOptions noise{.angle = options.angle,
                                 .distance = percent * options.distance,
                                 .scale = percent * options.scale,
                                 .seed = options.seed};
    const Grammar grammar = grammar_of(drawing, options);
    return checked_edit(grammar, randomize(grammar, noise)).grammar;
}

/// The terminal that is meant; without a name, the only one.
std::string wanted_symbol(const Grammar& grammar, const std::string& name) {
    if (!name.empty()) return name;
    if (grammar.terminals.size() == 1) return grammar.terminals.front().symbol;
    std::string names;
    for (const Terminal& terminal : grammar.terminals) names += (names.empty() ? "" : ", ") + terminal.symbol;
    throw NothingToDo("Which part is to be replaced? Type one of these into Symbol: " + names);
}

Replacement wanted_replacement(const std::string& symbol, const std::string& document, const std::vector<std::string>& others,
                               const InkscapeOptions& options) {
    if (!options.with.empty()) return parse_replacement(symbol + "=" + options.with);
    if (others.empty())
        throw NothingToDo(
            "Nothing was given to replace it by: choose a file, or select the new object together with the group of the rules.");
    const SvgReplacement object(document, others, {.file_name = "document", .split_compound_paths = false});
    return {symbol, OtherDrawing{object.scene().elements, symbol + "New"}, "the selected object"};
}

Grammar replaced(const SvgReplacement& drawing, const std::string& document, const std::vector<std::string>& others,
                 const InkscapeOptions& options) {
    const Grammar grammar = grammar_of(drawing, options);
    const std::string symbol = wanted_symbol(grammar, options.symbol);
    return checked_edit(grammar, replace_symbols(grammar, {wanted_replacement(symbol, document, others, options)})).grammar;
}

std::string changed_document(const std::string& document, const InkscapeOptions& options) {
    // Replace may be told by selection what to put in.
    IdsByRules ids{options.ids, {}};
    if (options.command == InkscapeCommand::replace) {
        ids = ids_by_rules(document, options.ids);
        if (ids.with_rules.empty()) std::swap(ids.with_rules, ids.others);
    }
    const SvgReplacement drawing(document, ids.with_rules, {.file_name = "document"});
    if (drawing.scene().elements.empty())
        throw NothingToDo(
            "There is nothing to work on: the selection is empty, locked or hidden, or draws nothing that Rinceau understands.");
    const auto wanted = [&] {
        switch (options.command) {
            case InkscapeCommand::find_rules:
                return found_grammar(drawing, options.analyze, false);
            case InkscapeCommand::symmetrize:
                return symmetrized(drawing, options);
            case InkscapeCommand::randomize:
                return randomized(drawing, options);
            case InkscapeCommand::replace:
                break;
        }
        return replaced(drawing, document, ids.others, options);
    };
    const Grammar grammar = wanted();
    if (drawing.overtaken() > 0)
        say(std::to_string(drawing.overtaken()) +
            " objects that were not selected lay above selected ones; they lie below them now, as after Object > Group.");
    return drawing.document_with({to_svg_clones(grammar).bytes, to_text(grammar), "Rinceau"});
}

int run_inkscape(const InkscapeOptions& options) {
    try {
        write_output("", changed_document(read_input(options.document), options));
        return exit_status::done;
    } catch (const NothingToDo& reason) {
        // without any output Inkscape leaves the document, and its history, alone
        say(reason.what());
        return exit_status::input_at_fault;
    }
}

void add_command_options(CLI::App& verb, InkscapeOptions& options) {
    constexpr double largest_tolerance = 1;  // an element's own size
    verb.add_option("--tolerance", options.analyze.tolerance,
                    "Largest deviation of a repetition, in element sizes; 0 tries several and keeps the shortest rules")
        ->check(number_between(0, largest_tolerance))
        ->capture_default_str()
        ->type_name("T");
    verb.add_option("--angle", options.angle, "randomize: standard deviation of angles, in degrees")
        ->check(CLI::NonNegativeNumber.description(""))
        ->type_name("SD");
    verb.add_option("--distance", options.distance, "randomize: standard deviation of distances, in per cent")
        ->check(CLI::NonNegativeNumber.description(""))
        ->type_name("SD");
    verb.add_option("--scale", options.scale, "randomize: standard deviation of scales, in per cent")
        ->check(CLI::NonNegativeNumber.description(""))
        ->type_name("SD");
    verb.add_option("--seed", options.seed, "randomize: which of the random drawings")->capture_default_str()->type_name("N");
    verb.add_option("--symbol", options.symbol, "replace: what is replaced; without it, the only thing that repeats")
        ->type_name("SYMBOL");
    verb.add_option("--with", options.with,
                    "replace: what takes its place (.svg, .lsys); without it, the objects selected beside the group of the rules")
        ->type_name("FILE");
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
                                                          {"symmetrize", InkscapeCommand::symmetrize},
                                                          {"randomize", InkscapeCommand::randomize},
                                                          {"replace", InkscapeCommand::replace}};
    verb->add_option("--command", options->command, "What to do; without it, find_rules")
        ->transform(CLI::CheckedTransformer(commands).description(""))
        ->type_name("find_rules|symmetrize|randomize|replace");
    add_command_options(*verb, *options);
    // what Inkscape passes besides
    verb->add_option("--selected-nodes", options->nodes)->allow_extra_args(false)->group("");
}

}  // namespace rinceau
