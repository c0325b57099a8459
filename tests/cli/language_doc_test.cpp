// Every example of docs/language.md is a good grammar that draws something, and gives what is said of it.

#include <sstream>

#include <catch2/catch.hpp>

#include "program.h"

using namespace rinceau::test;

namespace {

struct Block {
    std::string kind;  // behind the opening ```
    std::string text;
    int line = 0;
};

std::vector<Block> blocks_of(const std::string& page) {
    std::vector<Block> blocks;
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

std::string file_of(const Block& block) {
    const std::size_t blank = block.kind.find(' ');
    return blank == std::string::npos ? "example.lsys" : block.kind.substr(blank + 1);
}

/// Mistakes as the page shows them, without the name of the file.
std::string without_file(const std::string& mistakes) {
    std::string result;
    std::istringstream text(mistakes);
    for (std::string line; std::getline(text, line);) result += line.substr(line.find(':') + 1) + '\n';
    return result;
}

void check_good(const std::string& file, bool is_library, const ScratchFolder& scratch) {
    const ProgramRun check = run_rinceau({"check", file}, {.folder = scratch.path()});
    CHECK(check.status == 0);
    CHECK(check.err.empty());  // no hints either
    const ProgramRun render = run_rinceau({"render", file}, {.folder = scratch.path()});
    CAPTURE(render.err);
    CHECK(render.status == 0);
    const bool draws = render.out.find("<path") != std::string::npos || render.out.find("<text") != std::string::npos;
    CHECK(draws);
    const bool has_canvas = read_file(scratch.file(file)).find("\ncanvas ") != std::string::npos;
    CHECK((has_canvas || is_library));  // without one only a corner of it is seen
}

}  // namespace

TEST_CASE("Every example of the language's page does what the page says") {
    const ScratchFolder scratch;
    const std::vector<Block> blocks = blocks_of(read_file(std::string(RINCEAU_SOURCE_DIR) + "/docs/language.md"));
    int examples = 0;
    std::string file;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const Block& block = blocks[i];
        CAPTURE(block.line, block.text);
        if (block.text.starts_with("lsystem 1\n")) {
            ++examples;
            file = file_of(block);
            write_file(scratch.file(file), block.text);
            const bool is_faulty = i + 1 < blocks.size() && blocks[i + 1].kind == "checked";
            const bool is_library = file != "example.lsys";
            if (!is_faulty) check_good(file, is_library, scratch);
        } else if (block.kind == "derived") {
            CHECK(run_rinceau({"derive", file}, {.folder = scratch.path()}).out == block.text);
        } else if (block.kind == "checked") {
            const ProgramRun check = run_rinceau({"check", file}, {.folder = scratch.path()});
            CHECK(check.status == 1);
            CHECK(without_file(check.err) == block.text);
        } else {
            CHECK((block.kind == "ebnf" || block.kind.empty()));  // a part of a grammar
        }
    }
    CHECK(examples >= 18);
}
