// rinceau check: what is wrong with a grammar, and where.

#include <filesystem>

#include "cli/exit_status.h"
#include "cli/growth_input.h"
#include "cli/messages.h"
#include "cli/verbs.h"
#include "files/files.h"
#include "growth/surface/check_shape_grammar.h"
#include "growth/surface/parse_shape_grammar.h"
#include "lsystem/grammar_text.h"

namespace rinceau {
namespace {

struct CheckOptions {
    std::string input;
};

/// Of an L-system or a shape grammar.
GrammarFindings findings_of(const std::string& name, const std::string& label) {
    const bool is_called_so = std::filesystem::path(name).extension() == ".fgsg";
    const std::string text = is_called_so ? read_input(name) : read_grammar_text(name);
    if (is_called_so || looks_like_shape_grammar(text)) return inspect_shape_grammar(text, label, files_beside(name));
    return inspect_grammar(text, label, read_grammar_text);
}

int check(const CheckOptions& options) {
    const std::string label = input_label(options.input);
    const GrammarFindings findings = findings_of(options.input, label);
    for (const Warning& mistake : findings.mistakes) say(located(mistake.place, mistake.message));
    if (!findings.mistakes.empty()) return exit_status::input_at_fault;
    for (const Warning& hint : findings.hints) say(located(hint.place, "hint: " + hint.message));
    write_output("", label + ": good\n");
    return exit_status::done;
}

}  // namespace

void add_check(CLI::App& program, Job& job) {
    const auto [verb, options] = add_verb<CheckOptions>(program, job, "check", "Say what is wrong with a grammar, and where",
                                                        "rinceau check samples/rosette.lsys", check);
    verb->add_option("RULES", options->input, "The grammar (.lsys or .fgsg, or - for standard input)")->required();
}

}  // namespace rinceau
