// rinceau man, rinceau completion: what the system is told about the program.

#include "cli/completion.h"
#include "cli/exit_status.h"
#include "files/files.h"
#include "cli/manual_page.h"
#include "cli/verbs.h"

namespace rinceau {
namespace {

struct ManualOptions {
    const CLI::App* program = nullptr;
};

struct CompletionOptions {
    const CLI::App* program = nullptr;
    std::string shell;
};

int print_manual(const ManualOptions& options) {
    write_output("", manual_page(describe_program(*options.program), RINCEAU_VERSION));
    return exit_status::done;
}

int print_completion(const CompletionOptions& options) {
    const ProgramDescription program = describe_program(*options.program);
    write_output("", options.shell == "bash"  ? bash_completion(program)
                     : options.shell == "zsh" ? zsh_completion(program)
                                              : fish_completion(program));
    return exit_status::done;
}

}  // namespace

void add_man(CLI::App& program, Job& job) {
    const auto [verb, options] =
        add_verb<ManualOptions>(program, job, "man", "Print the manual page", "rinceau man | man -l -", print_manual);
    options->program = &program;
}

void add_completion(CLI::App& program, Job& job) {
    const auto [verb, options] =
        add_verb<CompletionOptions>(program, job, "completion", "Print what a shell needs to complete command lines",
                                    "rinceau completion bash > ~/.local/share/bash-completion/completions/rinceau",
                                    print_completion);
    options->program = &program;
    verb->add_option("SHELL", options->shell, "The shell")
        ->required()
        ->check(CLI::IsMember({"bash", "zsh", "fish"}).description(""))
        ->type_name("bash|zsh|fish");
}

}  // namespace rinceau
