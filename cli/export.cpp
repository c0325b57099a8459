// rinceau export: grammar -> a file for another program.

#include <filesystem>

#include "cli/derive_options.h"
#include "cli/exit_status.h"
#include "files/files.h"
#include "files/output_file.h"
#include "cli/messages.h"
#include "cli/verbs.h"
#include "exports/export_formats.h"
#include "lsystem/grammar_text.h"

namespace rinceau {
namespace {

struct ExportVerbOptions {
    std::string input;
    std::string format;
    std::string output;
    DeriveOptions derive;
    bool live_random = false;
};

/// Letters, digits and underscores of the input's name.
std::string name_of(const std::string& input) {
    std::string name;
    for (const char c : std::filesystem::path(input).stem().string()) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        name += plain ? c : '_';
    }
    const bool starts_with_letter = !name.empty() && (name.front() < '0' || name.front() > '9') && name.front() != '_';
    return starts_with_letter ? name : "rinceau" + name;
}

std::string companion_name(const std::string& output, const std::string& ending) {
    return std::filesystem::path(output).replace_extension(ending).string();
}

int export_rules(const ExportVerbOptions& options) {
    expect_writable(options.output);
    const ExportFormat& format = *find_export_format(options.format);
    const Grammar grammar = format.keeps_uses ? read_grammar_as_written(options.input) : read_grammar(options.input);
    const Export result = format.write(
        grammar, {.derive = options.derive, .name = name_of(options.input), .live_random = options.live_random});
    for (const std::string& note : result.notes) say("note: " + note);
    const bool to_file = !options.output.empty() && options.output != "-";
    if (!to_file && !result.companions.empty()) say("note: files that belong beside this one are written only with -o FILE");
    if (to_file) {
        for (const CompanionFile& companion : result.companions)
            write_output(companion_name(options.output, companion.ending), companion.bytes);
    }
    write_output(options.output, result.bytes);
    return exit_status::done;
}

}  // namespace

void add_export(CLI::App& program, Job& job) {
    const auto [verb, options] =
        add_verb<ExportVerbOptions>(program, job, "export", "Write a grammar for another program",
                                    "rinceau export samples/rosette.lsys --to svg -o rosette.svg", export_rules);
    verb->add_option("RULES", options->input, "The grammar (.lsys, or - for standard input)")->required();
    std::vector<std::string> names;
    std::string help = "For which program:";
    for (const ExportFormat& format : export_formats()) {
        names.emplace_back(format.name);
        help += ' ' + std::string(format.name) + " (" + std::string(format.help) + ")";
    }
    verb->add_option("--to", options->format, help)->required()->check(CLI::IsMember(names))->type_name("FORMAT");
    verb->add_option("-o,--output", options->output, "Where to write it; without it, to standard output")->type_name("FILE");
    add_derive_options(*verb, options->derive);
    verb->add_flag("--live-random", options->live_random,
                   "Write what is drawn by chance as such, where the format can; else it is frozen at the seed");
}

}  // namespace rinceau
