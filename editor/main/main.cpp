// rinceau-editor: the program behind `rinceau edit`.

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <new>
#include <regex>
#include <string>

#include "editor/main/picture_file.h"
#include "editor/main/session.h"
#include "files/signals_held.h"
#include "files/standard_streams.h"

namespace {

constexpr int command_line_at_fault = 2;
constexpr int limit_reached = 3;
constexpr int program_at_fault = 70;
constexpr int largest_side = 16384;  // that OpenGL draws everywhere
constexpr int smallest_side = 16;

/// "1280x800" into two numbers; a message if it is something else.
std::string read_size(const std::string& text, rinceau::EditorOptions& options) {
    std::smatch parts;
    if (std::regex_match(text, parts, std::regex("([0-9]{1,5})x([0-9]{1,5})"))) {
        options.width = std::stoi(parts[1]);
        options.height = std::stoi(parts[2]);
        const auto fits = [](int side) { return smallest_side <= side && side <= largest_side; };
        if (fits(options.width) && fits(options.height)) return {};
    }
    return "expected a size in pixels like 1280x800, each side from 16 to 16384, found '" + text + "'";
}

int edit(int argc, char** argv) {
    CLI::App program("The editor: a drawing and its rules, side by side", "rinceau edit");
    rinceau::EditorOptions options;
    constexpr float least_scale = 0.5F;
    constexpr float greatest_scale = 4;
    std::string size;
    program.set_version_flag("--version", "rinceau-editor " RINCEAU_VERSION)->description("Print the version");
    program.add_option("FILE", options.file, "A drawing (.svg), a grammar (.lsys) or a project");
    program.add_option("--screenshot", options.screenshot, "Draw the window into this PNG and leave")->type_name("FILE");
    program.add_option("--size", size, "Size of the window, or of the screenshot in pixels")->type_name("WxH");
    program.add_option("--scale", options.scale, "Size of text and buttons; without it, as the display is set")
        ->check(CLI::Range(least_scale, greatest_scale).description(""))
        ->type_name("S");
    program.add_flag("--light", options.light)->group("");
    program.add_option("--autosave-seconds", options.autosave_seconds)->group("");
    program.add_option("--places", options.places)->group("");
    CLI::Option* picture = program.add_option("--picture", options.picture)->group("");
    program.add_option("--width", options.picture_width)->group("")->needs(picture)->check(CLI::Range(1, largest_side));
    program.add_flag("--as-drawing", options.as_drawing)->group("")->needs(picture);
    program.failure_message([](const CLI::App*, const CLI::Error& error) {
        return "rinceau edit: " + std::string(error.what()) + "\nSee 'rinceau edit --help'\n";
    });
    try {
        program.parse(argc, argv);
        const std::string fault = size.empty() ? "" : read_size(size, options);
        if (!fault.empty()) throw CLI::ValidationError("--size", fault);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : command_line_at_fault;
    }
    if (!options.picture.empty()) return rinceau::write_picture_file(options);
    return rinceau::run_editor(options);
}

}  // namespace

int main(int argc, char** argv) {
    rinceau::open_standard_streams();
    rinceau::let_writes_fail();
    try {
        return edit(argc, argv);
    } catch (const std::bad_alloc&) {
        std::fputs("rinceau edit: the memory does not suffice; what was not saved is offered at the next start\n", stderr);
        return limit_reached;
    } catch (const std::exception& error) {
        std::fprintf(stderr,
                     "rinceau edit: the program itself is at fault, please report it: %s\n"
                     "What was not saved is offered at the next start\n",
                     error.what());
        return program_at_fault;
    }
}
