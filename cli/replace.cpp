// rinceau replace: symbols by other symbols, drawings, symbols of other grammars.

#include <map>

#include "cli/derive_options.h"
#include "cli/edit_output.h"
#include "cli/exit_status.h"
#include "files/files.h"
#include "cli/messages.h"
#include "cli/replacement_text.h"
#include "cli/verbs.h"
#include "lsystem/edit_replace.h"
#include "lsystem/grammar_text.h"
#include "lsystem/resolve_uses.h"

namespace rinceau {
namespace {

struct ReplaceVerbOptions {
    EditFiles files;
    std::vector<std::string> replacements;
    std::vector<std::string> addresses;
    ReplaceOptions replace;
};

/// "1.2.3" -> 1, 2, 3.
std::vector<int> parse_address(const std::string& text) {
    try {
        return parse_grammar("lsystem 1\nexcept " + text + " ->").exceptions.at(0).address;
    } catch (const InputError&) {
        throw CLI::ValidationError("--at", "expected an address, such as 1.2.3, found '" + text + "'");
    }
}

int replace(const ReplaceVerbOptions& options) {
    const Grammar grammar = read_for_edit(options.files);
    ReplaceOptions how = options.replace;
    how.derive = options.files.derive;
    how.resolve = [](const Grammar& written) { return resolve_uses(written, read_input); };
    for (const std::string& address : options.addresses) how.at.push_back(parse_address(address));
    std::vector<Replacement> replacements;
    for (const std::string& text : options.replacements) replacements.push_back(parse_replacement(text));
    write_edit(grammar, replace_symbols(grammar, replacements, how), options.files);
    return exit_status::done;
}

}  // namespace

void add_replace(CLI::App& program, Job& job) {
    const auto [verb, options] = add_verb<ReplaceVerbOptions>(
        program, job, "replace", "Put symbols, drawings or parts of other grammars in the place of symbols",
        "rinceau replace samples/mandala.lsys Star=Tear Tear=samples/vine.lsys#Leaf -o mandala2.lsys", replace);
    add_edit_options(*verb, options->files);
    verb->add_option("SYMBOL=WITH", options->replacements,
                     "A symbol and what takes its place: another symbol (Leaf, Ring(8)), a drawing (leaf.svg), a symbol of "
                     "another grammar (vine.lsys#Leaf) or all of it (vine.lsys), or nothing, which erases. All at once: A=B "
                     "B=A swaps")
        ->required()
        ->type_name("");
    const std::map<std::string, ReplaceFit> fits{{"none", ReplaceFit::none},
                                                 {"inside", ReplaceFit::inside},
                                                 {"cover", ReplaceFit::cover},
                                                 {"width", ReplaceFit::width},
                                                 {"height", ReplaceFit::height}};
    verb->add_option(
            "--fit", options->replace.fit,
            "How large: none = as it is, inside = as fits into the old one's box (the default), cover, width, height")
        ->transform(CLI::CheckedTransformer(fits).description(""))
        ->type_name("HOW");
    verb->add_option("--turn", options->replace.turn, "Turn what is put in by so many degrees, to the left")
        ->type_name("DEG");
    verb->add_option("--at", options->addresses,
                     "Only at this address, as an exception to the rules; may be given more than once")
        ->type_name("1.2.3")
        ->delimiter(',')
        ->expected(1)
        ->take_all();
    verb->add_flag("--restyle", options->replace.restyle,
                   "Paint what comes from elsewhere in the style that is in force where it is put");
    verb->add_flag("--keep", options->replace.keep, "Keep rules, outlines and styles that nothing uses any more");
    add_derive_options(*verb, options->files.derive);
}

}  // namespace rinceau
