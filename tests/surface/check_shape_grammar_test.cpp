#include <catch2/catch.hpp>

#include "growth/surface/check_shape_grammar.h"

using namespace rinceau;

namespace {

std::vector<std::string> hints_of(const std::string& text) {
    const GrammarFindings findings = inspect_shape_grammar(text);
    CHECK(findings.mistakes.empty());
    std::vector<std::string> hints;
    for (const Warning& hint : findings.hints) hints.push_back(std::to_string(hint.place.line) + " " + hint.message);
    return hints;
}

std::vector<int> lines_with_mistakes(const std::string& text, const ReadNamedFile& read_file = {}) {
    std::vector<int> lines;
    for (const Warning& mistake : inspect_shape_grammar(text, "x.fgsg", read_file).mistakes)
        lines.push_back(mistake.place.line);
    return lines;
}

bool goes_on(const std::string& text) {
    for (const std::string& hint : hints_of(text))
        if (hint.find("goes on for ever") != std::string::npos) return true;
    return false;
}

}  // namespace

TEST_CASE("a checked shape grammar names all of its mistakes by place") {
    CHECK(lines_with_mistakes("param u = v\n"
                              "shape leaf = blatt\n"
                              "field F1 = wind\n"
                              "option cul = rule\n"
                              "axiom vertex 0 A(u) B\n"
                              "A(n) ~ I(\"leav\") Rz(F1.lenth1)\n") == std::vector<int>{1, 2, 3, 4, 5, 6, 6});
    CHECK(lines_with_mistakes("param u = 1\n") == std::vector<int>{1});  // no axiom
    CHECK(lines_with_mistakes("option follow = F2\nfield F1 = curvature\naxiom vertex 0 Rz(1)\n") == std::vector<int>{1});
}

TEST_CASE("files of a checked grammar are read if they can be") {
    const std::string text = "field F = file \"f.json\"\naxiom vertex 0 Rz(1)\n";
    CHECK(lines_with_mistakes(text).empty());
    const auto none = [](const std::string& name) -> std::string { throw InputError({name}, "cannot be read"); };
    CHECK(lines_with_mistakes(text, none).size() == 1);
}

TEST_CASE("a symbol goes on for ever if neither condition, probability nor collision can end it") {
    CHECK(goes_on("shape r = box\naxiom vertex 0 A\nA ~ T(1) I(\"r\") A"));
    CHECK(goes_on("shape r = box\naxiom vertex 0 A\nA ~ B\nB ~ I(\"r\") A"));
    CHECK(!goes_on("shape r = box\naxiom vertex 0 A\nA ~ T(1) IC(\"r\") A"));
    CHECK(!goes_on("shape r = box\naxiom vertex 0 A\nA ~ P [T(1) A] [T(-1) A]\nP ~ IC(\"r\")"));
    CHECK(!goes_on("shape r = box\naxiom vertex 0 A(0)\nA(n) : n < 5 ~ I(\"r\") A(n+1)"));
    CHECK(!goes_on("shape r = box\naxiom vertex 0 A\nA ~ I(\"r\") A : 0.9\nA ~ : 0.1"));
    CHECK(!goes_on("shape r = box\naxiom vertex 0 A\nA ~ I(\"r\")"));
    CHECK(!goes_on("option collide = all\nshape r = box\naxiom vertex 0 A\nA ~ T(1) I(\"r\") A"));
}

TEST_CASE("what nothing uses is a hint") {
    const auto hints =
        hints_of("param u = 1\nparam v = u\nshape a = box\nfield F = curvature\naxiom vertex 0 A\nA ~ Rz(1)\nB ~ Rz(2)");
    CHECK(hints == std::vector<std::string>{"2 the param 'v' is never used", "3 the shape 'a' is never placed",
                                            "7 no axiom leads to the symbol 'B': its rules are never applied"});
}
