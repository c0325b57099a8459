#include <algorithm>
#include <sstream>

#include <catch2/catch.hpp>

#include "program.h"

using namespace rinceau::test;

namespace {
/// Their examples speak of samples and write beside them.
const std::vector<std::string> verbs_on_samples = {"analyze",   "render",     "derive",  "check",  "set",
                                                   "randomize", "symmetrize", "replace", "export", "normalize",
                                                   "arrange",   "pack",       "grow",    "field"};
/// Their examples are for a shell or for documents of one's own.
const std::vector<std::string> other_verbs = {"edit", "inkscape", "man", "completion"};

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// The line after "Example:", as words.
std::vector<std::string> example_words(const std::string& help) {
    std::vector<std::string> words;
    std::istringstream line(help.substr(help.find("Example:\n") + 9));
    std::string text;
    std::getline(line, text);
    std::istringstream split(text);
    while (split >> text) words.push_back(text);
    return words;
}
}  // namespace

TEST_CASE("Every verb is listed and tells how it is used, on standard output") {
    const ProgramRun program = run_rinceau({"--help"});
    CHECK(program.status == 0);
    CHECK(program.err.empty());
    std::vector<std::string> verbs = verbs_on_samples;
    verbs.insert(verbs.end(), other_verbs.begin(), other_verbs.end());
    for (const std::string& verb : verbs) {
        CAPTURE(verb);
        CHECK(contains(program.out, "  " + verb + " "));
        const ProgramRun help = run_rinceau({verb, "--help"});
        CHECK(help.status == 0);
        CHECK(contains(help.out, "Example:\n  rinceau " + verb + " "));
    }
}

TEST_CASE("The example of every verb's help works as it stands") {
    for (const std::string& verb : verbs_on_samples) {
        CAPTURE(verb);
        std::vector<std::string> words = example_words(run_rinceau({verb, "--help"}).out);
        REQUIRE(words.size() >= 3);
        REQUIRE(words.front() == "rinceau");
        words.erase(words.begin());
        // The examples speak from the project's folder; their outputs go to a folder of this test.
        const ScratchFolder scratch;
        std::filesystem::create_directory_symlink(std::string(RINCEAU_SOURCE_DIR) + "/samples", scratch.path() / "samples");
        const ProgramRun run = run_rinceau(words, {.folder = scratch.path()});
        CHECK(run.err.find("Error") == std::string::npos);
        CHECK(run.status == 0);
    }
}

TEST_CASE("The version is one line on standard output") {
    const ProgramRun run = run_rinceau({"--version"});
    CHECK(run.status == 0);
    CHECK(run.out.starts_with("rinceau "));
    CHECK(std::count(run.out.begin(), run.out.end(), '\n') == 1);
}

TEST_CASE("A wrong command line gives status 2 and leaves standard output empty") {
    const std::string svg = sample("rosette.svg");
    const std::string lsys = sample("rosette.lsys");
    const std::vector<std::vector<std::string>> wrong = {
        {},
        {"invent"},
        {"analyze"},
        {"analyze", svg, "extra.svg"},
        {"analyze", svg, "--frobnicate"},
        {"analyze", svg, "--tolerance", "much"},
        {"analyze", svg, "--tolerance", "-1"},
        {"analyze", svg, "--tolerance", "nan"},
        {"analyze", svg, "--similarity", "0"},
        {"analyze", svg, "--threads", "-1"},
        {"analyze", svg, "--weights", "n=1,n=2"},
        {"analyze", svg, "--weights", "q=1"},
        {"analyze", svg, "--weights", "n=5"},
        {"analyze", svg, "--weights", ""},
        {"analyze", svg, "--objective", "taste"},
        {"analyze", svg, "-o", "rules.txt"},
        {"analyze", svg, "-o", "-", "--print"},
        {"analyze", svg, "--report", "report.svg"},
        {"analyze", svg, "--spaces", "spaces.png"},
        {"render", lsys, "-o", "picture.jpg"},
        {"render", lsys, "-o", "picture.svg", "--width", "100"},
        {"render", lsys, "-o", "picture.png", "--width", "0"},
        {"render", lsys, "--color-by", "taste"},
        {"render", lsys, "--depth", "-3"},
        {"derive", lsys, "--seed", "x"},
        {"derive", lsys, "--max-modules", "0"},
        {"check"},
        {"normalize", svg, "-o", "picture.png"},
    };
    const ScratchFolder scratch;
    for (const std::vector<std::string>& arguments : wrong) {
        CAPTURE(arguments);
        const ProgramRun run = run_rinceau(arguments, {.folder = scratch.path()});
        CHECK(run.status == 2);
        CHECK(run.out.empty());
        CHECK(run.err.starts_with("rinceau: "));
    }
    CHECK(scratch.names().empty());
}
