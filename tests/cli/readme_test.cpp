// What the README tells a newcomer to type works.

#include <catch2/catch.hpp>

#include "program.h"

using namespace rinceau::test;

TEST_CASE("The commands of the README work, one after the other") {
    const ScratchFolder scratch;
    std::filesystem::create_directory_symlink(sample(""), scratch.path() / "samples");
    const std::vector<std::vector<std::string>> commands = page_commands("README.md");
    CHECK(commands.size() >= 5);
    for (const std::vector<std::string>& command : commands) {
        CAPTURE(command);
        const ProgramRun run = run_rinceau(command, {.folder = scratch.path()});
        CAPTURE(run.err);
        CHECK(run.status == 0);
    }
}
