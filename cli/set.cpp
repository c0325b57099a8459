// rinceau set: the numbers of a grammar, listed and changed.

#include "lsystem/set_numbers.h"

#include "cli/derive_options.h"
#include "cli/edit_output.h"
#include "cli/exit_status.h"
#include "files/files.h"
#include "cli/messages.h"
#include "cli/numbers_output.h"
#include "cli/verbs.h"

namespace rinceau {
namespace {

struct SetVerbOptions {
    EditFiles files;
    std::vector<std::string> edits;
    bool all = false;
    bool json = false;
    bool open = false;
};

int list_numbers(const SetVerbOptions& options) {
    if (!options.files.output.empty())
        throw CLI::ValidationError("-o", "expected NAME=VALUE beside it: without an edit there is nothing to write");
    const std::vector<GrammarNumber> numbers = grammar_numbers(read_for_edit(options.files));
    write_output("", options.json ? numbers_json(numbers) : numbers_text(numbers, options.all));
    return exit_status::done;
}

int set(const SetVerbOptions& options) {
    if (options.edits.empty()) return list_numbers(options);
    if (options.all || options.json)
        throw CLI::ValidationError("--all, --json", "expected no NAME=VALUE: they are for the list");
    const Grammar grammar = read_for_edit(options.files);
    std::vector<NumberEdit> edits;
    for (const std::string& text : options.edits) edits.push_back(parse_number_edit(text));
    write_edit(grammar, set_numbers(grammar, edits, {.keep_rings_closed = !options.open}), options.files);
    return exit_status::done;
}

}  // namespace

void add_set(CLI::App& program, Job& job) {
    const auto [verb, options] = add_verb<SetVerbOptions>(
        program, job, "set", "List the numbers of a grammar by name, or change them",
        "rinceau set samples/rosette.lsys Pearls.count=24 Outer.count+=4 -o wide.lsys",
        set);
    add_edit_options(*verb, options->files);
    verb->add_option(
            "EDITS", options->edits,
            "NAME=VALUE, with VALUE a number or an expression (bay=80*1.5); NAME+=2, -=2, *=2, /=2 and =150% change "
            "what it is; * in NAME stands for any characters")
        ->type_name("NAME=VALUE ..");
    verb->add_flag("--all", options->all, "List every number, also of the axiom, styles and exceptions");
    verb->add_flag("--json", options->json, "List as JSON, for other programs");
    verb->add_flag("--open", options->open, "Let a ring open: neither its turn follows its count, nor its count its turn");
    add_derive_options(*verb, options->files.derive);
}

}  // namespace rinceau
