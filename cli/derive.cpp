// rinceau derive: grammar -> the derived string of modules.

#include "lsystem/derive.h"
#include "cli/derive_options.h"
#include "cli/exit_status.h"
#include "files/files.h"
#include "files/output_file.h"
#include "cli/progress_bar.h"
#include "cli/verbs.h"

namespace rinceau {
namespace {

struct DeriveVerbOptions {
    std::string input;
    std::string output;
    DeriveOptions derive;
};

int derive_string(const DeriveVerbOptions& options) {
    expect_writable(options.output);
    const Grammar grammar = read_grammar(options.input);
    OutputFile output(options.output);
    {
        ProgressBar bar;
        derive_text(
            grammar, options.derive, [&](std::string_view piece) { output.write(piece); }, bar.callback());
    }
    output.write("\n");
    output.finish();
    return exit_status::done;
}

}  // namespace

void add_derive(CLI::App& program, Job& job) {
    const auto [verb, options] =
        add_verb<DeriveVerbOptions>(program, job, "derive", "Print the string of modules that a grammar derives",
                                    "rinceau derive samples/rosette.lsys --depth 1", derive_string);
    verb->add_option("RULES", options->input, "The grammar (.lsys, or - for standard input)")->required();
    verb->add_option("-o,--output", options->output, "Where to write the string; without it, to standard output")
        ->type_name("FILE");
    add_derive_options(*verb, options->derive);
}

}  // namespace rinceau
