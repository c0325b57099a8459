// What the README tells a newcomer to type works.

#include <sstream>

#include <catch2/catch.hpp>

#include "program.h"

using namespace rinceau::test;

namespace {

// The lines of README.md that start the program, each as words without the program's name.
std::vector<std::vector<std::string>> readme_commands() {
    std::vector<std::vector<std::string>> commands;
    std::istringstream text(read_file(std::string(RINCEAU_SOURCE_DIR) + "/README.md"));
    bool in_block = false;
    for (std::string line; std::getline(text, line);) {
        if (line.starts_with("```")) in_block = line == "```sh";
        if (!in_block || !line.starts_with("rinceau ")) continue;
        std::istringstream words(line.substr(0, line.find('#')));
        std::vector<std::string> command;
        for (std::string word; words >> word;) command.push_back(word);
        command.erase(command.begin());
        commands.push_back(command);
    }
    return commands;
}

}  // namespace

TEST_CASE("The commands of the README work, one after the other") {
    const ScratchFolder scratch;
    std::filesystem::create_directory_symlink(sample(""), scratch.path() / "samples");
    const std::vector<std::vector<std::string>> commands = readme_commands();
    CHECK(commands.size() >= 5);
    for (const std::vector<std::string>& command : commands) {
        CAPTURE(command);
        const ProgramRun run = run_rinceau(command, {.folder = scratch.path()});
        CAPTURE(run.err);
        CHECK(run.status == 0);
    }
}
