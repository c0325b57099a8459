#pragma once
// The verbs of the program: each function adds one to the command line, in the file of its name.

#include <functional>
#include <memory>
#include <string>

#include <CLI/App.hpp>

namespace rinceau {

/// What the command line asks for, filled in while it is parsed; returns the exit status, throws as main.cpp knows.
using Job = std::function<int()>;

void add_analyze(CLI::App& program, Job& job);
void add_render(CLI::App& program, Job& job);
void add_derive(CLI::App& program, Job& job);
void add_check(CLI::App& program, Job& job);
void add_export(CLI::App& program, Job& job);
void add_set(CLI::App& program, Job& job);
void add_randomize(CLI::App& program, Job& job);
void add_symmetrize(CLI::App& program, Job& job);
void add_normalize(CLI::App& program, Job& job);
void add_replace(CLI::App& program, Job& job);
void add_arrange(CLI::App& program, Job& job);
void add_pack(CLI::App& program, Job& job);
void add_field(CLI::App& program, Job& job);
void add_grow(CLI::App& program, Job& job);
void add_edit(CLI::App& program, Job& job);
void add_inkscape(CLI::App& program, Job& job);
void add_man(CLI::App& program, Job& job);
void add_completion(CLI::App& program, Job& job);

/// Declares a verb with options of type `Options`; parsing it makes `run` on them the job.
template <class Options>
std::pair<CLI::App*, Options*> add_verb(CLI::App& program, Job& job, const std::string& name, const std::string& help,
                                        const std::string& example, int (*run)(const Options&)) {
    const auto options = std::make_shared<Options>();
    CLI::App* verb = program.add_subcommand(name, help);
    verb->footer("Example:\n  " + example);
    verb->callback([options, run, &job] { job = [options, run] { return run(*options); }; });
    return {verb, options.get()};  // the callback keeps them alive
}

}  // namespace rinceau
