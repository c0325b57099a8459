// rinceau-editor: the program behind `rinceau edit`.

#include <CLI/CLI.hpp>

#include "editor/main/session.h"

int main(int argc, char** argv) {
    CLI::App program("The editor: a drawing and its rules, side by side", "rinceau edit");
    rinceau::EditorOptions options;
    program.add_option("FILE", options.file, "A drawing (.svg) or a grammar (.lsys)");
    program.add_option("--screenshot", options.screenshot, "Draw one frame into this PNG and leave");
    program.add_option("--places", options.places)->group("");
    CLI11_PARSE(program, argc, argv);
    return rinceau::run_editor(options);
}
