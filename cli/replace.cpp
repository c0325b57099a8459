// rinceau replace: symbols by other symbols, drawings, symbols of other grammars.

#include <algorithm>
#include <filesystem>
#include <map>

#include "cli/derive_options.h"
#include "cli/exit_status.h"
#include "cli/files.h"
#include "cli/messages.h"
#include "cli/verbs.h"
#include "lsystem/edit_replace.h"
#include "lsystem/grammar_text.h"
#include "lsystem/resolve_uses.h"
#include "scene/svg_read.h"

namespace rinceau {
namespace {

struct ReplaceVerbOptions {
    std::string input;
    std::string output;
    std::vector<std::string> replacements;
    std::vector<std::string> addresses;
    ReplaceOptions replace;
};

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
}

bool ends_with(const std::string& text, const std::string& ending) { return lower(text).ends_with(ending); }

/// "my leaf.svg" -> "My_leaf".
std::string symbol_for(const std::string& file) {
    std::string name;
    for (const char c : std::filesystem::path(file).stem().string()) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        name += plain ? c : '_';
    }
    if (!name.empty() && name.front() >= 'a' && name.front() <= 'z')
        name.front() = static_cast<char>(name.front() - 'a' + 'A');
    const bool starts_with_letter = !name.empty() && name.front() >= 'A' && name.front() <= 'Z';
    return starts_with_letter ? name : "Drawing" + name;
}

/// A string of modules, as it stands behind "axiom:".
ModuleTemplates parse_modules(const std::string& text, const std::string& what) {
    try {
        ModuleTemplates string = parse_grammar("lsystem 1\naxiom: " + text).axiom;
        for (ModuleTemplate& module : string) module.place = {};
        return string;
    } catch (const InputError&) {
        throw CLI::ValidationError(
            what,
            "expected a symbol, such as Leaf or Ring(8), a drawing.svg or a grammar.lsys#Symbol, found '" + text + "'");
    }
}

OtherDrawing read_drawing(const std::string& name) {
    SvgReadResult drawing = read_svg(read_input(name), {.file_name = input_label(name), .split_compound_paths = false});
    say_warnings(drawing.warnings);
    return {std::move(drawing.scene.elements), symbol_for(name)};
}

OtherGrammar read_other(const std::string& name, const std::string& modules, const std::string& what) {
    OtherGrammar other{read_grammar(name), {}, symbol_for(name)};
    if (!modules.empty()) other.string = parse_modules(modules, what);
    return other;
}

Replacement parse_replacement(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        throw CLI::ValidationError("SYMBOL=WITH", "expected a symbol, '=' and what takes its place, found '" + text + "'");
    Replacement replacement{.symbol = text.substr(0, equals), .label = text.substr(equals + 1)};
    const std::string& with = replacement.label;
    const std::size_t hash = lower(with).rfind(".lsys#");
    if (hash != std::string::npos) {
        const std::size_t end_of_file = with.find('#', hash);
        replacement.with = read_other(with.substr(0, end_of_file), with.substr(end_of_file + 1), text);
    } else if (ends_with(with, ".lsys")) {
        replacement.with = read_other(with, "", text);
    } else if (ends_with(with, ".svg") || ends_with(with, ".svgz")) {
        replacement.with = read_drawing(with);
    } else {
        replacement.with = OwnModules{parse_modules(with, text)};
    }
    return replacement;
}

/// "1.2.3" -> 1, 2, 3.
std::vector<int> parse_address(const std::string& text) {
    try {
        return parse_grammar("lsystem 1\nexcept " + text + " ->").exceptions.at(0).address;
    } catch (const InputError&) {
        throw CLI::ValidationError("--at", "expected an address, such as 1.2.3, found '" + text + "'");
    }
}

int replace(const ReplaceVerbOptions& options) {
    if (format_of(options.output, FileFormat::lsys) != FileFormat::lsys)
        throw CLI::ValidationError("-o", "expected a name that ends in .lsys, found '" + options.output + "'");
    expect_writable(options.output);
    ReplaceOptions how = options.replace;
    for (const std::string& address : options.addresses) how.at.push_back(parse_address(address));
    how.resolve = [](const Grammar& grammar) { return resolve_uses(grammar, read_input); };
    const Grammar grammar = read_grammar_as_written(options.input);
    std::vector<Replacement> replacements;
    for (const std::string& text : options.replacements) replacements.push_back(parse_replacement(text));

    const EditResult result = replace_symbols(grammar, replacements, how);
    write_output(options.output, to_text(result.grammar));
    for (const std::string& change : result.changes) say(change);
    return exit_status::done;
}

}  // namespace

void add_replace(CLI::App& program, Job& job) {
    const auto [verb, options] = add_verb<ReplaceVerbOptions>(
        program, job, "replace", "Put symbols, drawings or parts of other grammars in the place of symbols",
        "rinceau replace samples/mandala.lsys Star=Tear Tear=samples/vine.lsys#Leaf -o mandala2.lsys", replace);
    verb->add_option("RULES", options->input, "The grammar (.lsys, or - for standard input)")->required();
    verb->add_option("SYMBOL=WITH", options->replacements,
                     "A symbol and what takes its place: another symbol (Leaf, Ring(8)), a drawing (leaf.svg), a symbol of "
                     "another grammar (vine.lsys#Leaf) or all of it (vine.lsys), or nothing, which erases. All at once: A=B "
                     "B=A swaps")
        ->required()
        ->type_name("");
    verb->add_option("-o,--output", options->output, "The new grammar (.lsys); without it, to standard output")
        ->type_name("FILE");
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
    verb->add_flag("--keep", options->replace.keep, "Keep rules, outlines and styles that nothing uses any more");
    add_derive_options(*verb, options->replace.derive);
}

}  // namespace rinceau
