// rinceau: every core function from the command line.

#include <algorithm>
#include <cerrno>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/exit_status.h"
#include "cli/last_words.h"
#include "cli/messages.h"
#include "cli/verbs.h"
#include "files/output_error.h"
#include "files/signals_held.h"
#include "files/standard_streams.h"
#include "scene/input_error.h"

namespace {

using namespace rinceau;

int parse_and_run(CLI::App& program, const Job& job, std::vector<std::string> words) {
    try {
        std::ranges::reverse(words);  // as the library wants them
        program.parse(std::move(words));
        return job();
    } catch (const CLI::ParseError& error) {
        if (program.exit(error) != 0) return exit_status::command_line_at_fault;
        if (!std::cout.flush()) fail_output("<stdout>", errno);
        return exit_status::done;
    }
}

void describe(CLI::App& program) {
    constexpr std::size_t option_column = 30;
    program.description("Finds the L-system behind a drawing, and draws L-systems.");
    program.get_formatter()->column_width(option_column);
    program.set_version_flag("--version", "rinceau " RINCEAU_VERSION);
    program.footer(
        "Exit status: 0 done, 1 the input is at fault, 2 the command line is at fault, 3 a limit was reached,\n"
        "             4 an output could not be written, 5 some of many drawings failed,\n"
        "             70 the program itself is at fault.\n"
        "Example:\n"
        "  rinceau analyze samples/facade.svg\n"
        "'rinceau VERB --help' tells about a verb.");
    program.require_subcommand(1);
    program.failure_message([](const CLI::App* app, const CLI::Error& error) {
        return "rinceau: " + std::string(error.what()) + "\nSee '" + app->get_display_name() + " --help'\n";
    });
}

/// Inkscape starts a program without a verb; by this name it means that one. A field left empty in its dialog is no value.
std::vector<std::string> words_of(int argc, char** argv) {
    std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    if (argc == 0 || std::filesystem::path(argv[0]).stem() != "rinceau-inkscape") return words;
    std::erase_if(words, [](const std::string& word) { return word.starts_with("--") && word.ends_with('='); });
    words.insert(words.begin(), "inkscape");
    return words;
}

int run(int argc, char** argv) {
    CLI::App program("", "rinceau");
    Job job;
    describe(program);
    add_analyze(program, job);
    add_render(program, job);
    add_derive(program, job);
    add_check(program, job);
    add_export(program, job);
    add_set(program, job);
    add_randomize(program, job);
    add_symmetrize(program, job);
    add_normalize(program, job);
    add_replace(program, job);
    add_arrange(program, job);
    add_pack(program, job);
    add_field(program, job);
    add_grow(program, job);
    add_edit(program, job);
    add_inkscape(program, job);
    add_man(program, job);
    add_completion(program, job);
    return parse_and_run(program, job, words_of(argc, argv));
}

}  // namespace

int main(int argc, char** argv) {
    open_standard_streams();
    tell_when_memory_ends();
    const bool ends_at_broken_pipe = let_writes_fail();
    try {
        return run(argc, argv);
    } catch (const InputError& error) {
        say(error.what());
        return exit_status::input_at_fault;
    } catch (const LimitError& error) {
        say(error.what());
        return exit_status::limit_reached;
    } catch (const std::bad_alloc&) {
        say_memory_does_not_suffice();
        return exit_status::limit_reached;
    } catch (const std::length_error&) {
        say_memory_does_not_suffice();
        return exit_status::limit_reached;
    } catch (const OutputError& error) {
        if (error.code() == EPIPE && ends_at_broken_pipe) end_at_broken_pipe();
        say(error.what());
        return exit_status::output_not_written;
    } catch (const std::exception& error) {
        say(std::string("rinceau: the program itself is at fault, please report it: ") + error.what());
        return exit_status::program_at_fault;
    }
}
