// Bad input of every sort: a message with the place, status 1 or 3, quickly, in a gigabyte, with no output harmed.

#include <catch2/catch.hpp>

#include "program.h"

using namespace rinceau::test;

namespace {

#ifdef RINCEAU_SANITIZED
constexpr double longest_seconds = 60;  // sanitizers slow the program down
#else
constexpr double longest_seconds = 2;
#endif

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
}

std::string svg(const std::string& inside) {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\"\n"
           "     width=\"100\" height=\"100\">\n" +
           inside + "\n</svg>\n";
}

// a, b, .. each ten times the one before.
std::string entity_bomb() {
    std::string text = "<?xml version=\"1.0\"?>\n<!DOCTYPE svg [\n<!ENTITY a0 \"<rect width='1' height='1'/>\">\n";
    for (int i = 1; i <= 12; ++i) {
        const std::string before = "&a" + std::to_string(i - 1) + ";";
        text += "<!ENTITY a" + std::to_string(i) + " \"" + repeated(before, 10) + "\">\n";
    }
    return text + "]>\n" + svg("&a12;");
}

// g0 is drawn ten times by g1, that ten times by g2, ...
std::string use_bomb() {
    std::string text = "<defs><g id=\"g0\"><rect width=\"1\" height=\"1\"/></g>\n";
    for (int i = 1; i <= 12; ++i) {
        const std::string use = "<use xlink:href=\"#g" + std::to_string(i - 1) + "\"/>";
        text += "<g id=\"g" + std::to_string(i) + "\">" + repeated(use, 10) + "</g>\n";
    }
    return svg(text + "</defs><use xlink:href=\"#g12\"/>");
}

struct Refused {
    std::string name;
    std::string bytes;
    int status;
    std::string message_start;  ///< after the file's name
};

void check_refused(const std::vector<std::string>& verb_words, const std::string& ending, const Refused& bad) {
    CAPTURE(verb_words.front(), bad.name);
    const ScratchFolder scratch;
    const std::string input = scratch.file("bad." + ending);
    const std::string output = scratch.file(verb_words.back());
    write_file(input, bad.bytes);
    write_file(output, "old");
    const ProgramRun run = run_rinceau({verb_words.front(), input, "-o", output});
    CAPTURE(run.err.substr(0, 500), run.seconds, run.signal);
    CHECK(run.status == bad.status);
    CHECK(run.err.find(input + bad.message_start) != std::string::npos);
    CHECK(run.out.empty());
    CHECK(run.seconds < longest_seconds);
    CHECK(read_file(output) == "old");
    CHECK(scratch.names().size() == 2);
}

}  // namespace

TEST_CASE("A drawing that cannot be read is refused with its place") {
    const std::vector<Refused> drawings = {
        {"empty", "", 1, ":"},
        {"blank", " \n \n", 1, ":"},
        {"truncated in a tag", "<svg xmlns=\"http://www.w3.org/2000/svg\">\n<rect width=\"3", 1, ":2:"},
        {"truncated between tags", "<svg xmlns=\"http://www.w3.org/2000/svg\">\n<g>\n", 1, ":"},
        {"tags that cross", svg("<g><a></g></a>"), 1, ":3:"},
        {"not XML", "Dear reader,\nthis is a letter.\n", 1, ":1:"},
        {"HTML", "<html><body/></html>", 1, ":1:"},
        {"a PNG", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x08\6\0\0\0", 29), 1, ":"},
        {"zeros", std::string(1000, '\0'), 1, ":"},
        {"broken gzip", std::string("\x1f\x8b\x08\0\0\0\0\0\0\3\x55\x55\x55", 13), 1, ":"},
        {"entity bomb", entity_bomb(), 3, ":"},
        {"use bomb", use_bomb(), 3, ":"},
        {"nested groups", svg(repeated("<g>", 10'000) + "<rect width=\"1\" height=\"1\"/>" + repeated("</g>", 10'000)), 3,
         ":"},
    };
    for (const Refused& bad : drawings) {
        check_refused({"normalize", "out.svg"}, "svg", bad);
        check_refused({"analyze", "out.lsys"}, "svg", bad);
    }
}

TEST_CASE("A fault inside a drawing costs a warning with its place, not the drawing") {
    const std::vector<std::pair<std::string, std::string>> faults = {
        {"recursive use", "<g id=\"a\"><use xlink:href=\"#b\"/></g><g id=\"b\"><use xlink:href=\"#a\"/></g>"},
        {"not a number", "<rect x=\"NaN\" y=\"1\" width=\"10\" height=\"10\"/>"},
        {"a transform of no numbers", "<g transform=\"scale(NaN)\"><rect width=\"10\" height=\"10\"/></g>"},
        {"numbers near the end of all numbers", "<rect width=\"1e308\" height=\"1e308\" transform=\"scale(1e308)\"/>"},
        {"path that breaks off", "<path d=\"M0 0 L 10 10 L 20 fish\"/>"},
        {"unknown reference", "<use xlink:href=\"#nobody\"/>"},
    };
    for (const auto& [name, fault] : faults) {
        CAPTURE(name);
        const std::string good = "<circle cx=\"50\" cy=\"50\" r=\"7\" fill=\"#123456\"/>";
        const ProgramRun run = run_rinceau({"normalize", "-"}, {.input = svg(fault + "\n" + good)});
        CAPTURE(run.err);
        CHECK(run.status == 0);
        CHECK(run.err.starts_with("warning: <stdin>:3"));
        CHECK(run.out.find("#123456") != std::string::npos);
        CHECK(run.out.find("nan") == std::string::npos);
        CHECK(run.out.find("inf") == std::string::npos);
        CHECK(run.seconds < longest_seconds);
    }
}

TEST_CASE("A grammar that cannot be read is refused with its place") {
    const std::vector<Refused> grammars = {
        {"empty", "", 1, ":"},
        {"a drawing", svg(""), 1, ":1:"},
        {"a PNG", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16), 1, ":1:"},
        {"an unfinished rule", "axiom: A\nA ->\nB : m > -> A\n", 1, ":"},
    };
    for (const Refused& bad : grammars) check_refused({"render", "out.svg"}, "lsys", bad);
}

TEST_CASE("A grammar that explodes is stopped and the rule that exploded is named") {
    const std::string terminal = "terminal A: path \"M0 0L1 1\"\n";
    const std::vector<Refused> grammars = {
        {"two of itself", "lsystem 1\naxiom: P(100)\nP(m) : m > 0 -> A P(m-1) P(m-1)\n" + terminal, 3,
         ":3:1: production P "},
        {"without an end", "lsystem 1\naxiom: Q\nQ -> A Q Q\n" + terminal, 3, ":3:1: production Q "},
        {"a huge count", "lsystem 1\naxiom: P(1e9)\nP(m) : m > 0 -> A f(1) P(m-1)\n" + terminal, 3, ":3:1: production P "},
        {"a division by zero", "lsystem 1\naxiom: B(0)\nB(m) -> f(1/m) A\n" + terminal, 1, ":3:9: "},
        {"a number beyond all", "lsystem 1\naxiom: f(1e400) A\n" + terminal, 1, ":2:"},
    };
    for (const Refused& bad : grammars) {
        check_refused({"render", "out.svg"}, "lsys", bad);
        check_refused({"derive", "out.txt"}, "lsys", bad);
    }
}
