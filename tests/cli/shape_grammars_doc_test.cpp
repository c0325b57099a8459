// Every example of docs/shape_grammars.md is a good grammar without hints that grows something in the plane.

#include <sstream>
#include <vector>

#include <catch2/catch.hpp>

#include "program.h"

using namespace rinceau::test;

namespace {

struct PageBlock {
    std::string kind;  // behind the opening ```
    std::string text;
    int line = 0;
};

std::vector<PageBlock> page_blocks(const std::string& page) {
    std::vector<PageBlock> blocks;
    std::istringstream text(page);
    bool inside = false;
    int number = 0;
    for (std::string line; std::getline(text, line);) {
        ++number;
        if (line.starts_with("```")) {
            inside = !inside;
            if (inside) blocks.push_back({line.substr(3), {}, number});
        } else if (inside) {
            blocks.back().text += line + '\n';
        }
    }
    return blocks;
}

/// Mistakes as the page shows them, without the name of the file.
std::string without_file(const std::string& mistakes) {
    std::string result;
    std::istringstream text(mistakes);
    for (std::string line; std::getline(text, line);) result += line.substr(line.find(':') + 1) + '\n';
    return result;
}

void check_grows(const std::string& file, const ScratchFolder& scratch) {
    const ProgramRun check = run_rinceau({"check", file}, {.folder = scratch.path()});
    CHECK(check.err == "");  // no hints either
    CHECK(check.status == 0);
    const ProgramRun grown = run_rinceau({"grow", file}, {.folder = scratch.path()});
    CAPTURE(grown.err);
    CHECK(grown.status == 0);
    const bool draws = grown.out.find("<use") != std::string::npos || grown.out.find("stroke-width") != std::string::npos;
    CHECK(draws);
}

}  // namespace

TEST_CASE("Every example of the shape grammars' page does what the page says") {
    const ScratchFolder scratch;
    const auto blocks = page_blocks(read_file(std::string(RINCEAU_SOURCE_DIR) + "/docs/shape_grammars.md"));
    const std::string file = "example.fgsg";
    int examples = 0;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const PageBlock& block = blocks[i];
        CAPTURE(block.line, block.text);
        if (block.kind == "fgsg") {
            ++examples;
            write_file(scratch.file(file), block.text);
            const bool is_faulty = i + 1 < blocks.size() && blocks[i + 1].kind == "checked";
            if (!is_faulty) check_grows(file, scratch);
        } else if (block.kind == "checked") {
            const ProgramRun check = run_rinceau({"check", file}, {.folder = scratch.path()});
            CHECK(check.status == 1);
            CHECK(without_file(check.err) == block.text);
        } else {
            CHECK(block.kind == "ebnf");
        }
    }
    CHECK(examples >= 10);
}
