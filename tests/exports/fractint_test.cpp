#include "exports/fractint.h"

#include <catch2/catch.hpp>

#include "lsystem/grammar_text.h"

using namespace rinceau;
using Catch::Matchers::Contains;

namespace {

Export fractint_of(const std::string& text) { return to_fractint(parse_grammar("lsystem 1\n" + text), {.name = "Row"}); }

const std::string stroke = "style 1: fill none; stroke #ff0000\nterminal A: style 1; path \"M0 0V-10\"\n";

}  // namespace

TEST_CASE("A row is a symbol that is doubled again and again") {
    const std::string text =
        fractint_of("axiom: P(64)\nP(m) : m > 0 -> [A] f(27.5) *(0.993) +(8.5) P(m-1)\n" + stroke).bytes;
    CHECK_THAT(text, Contains("Row {\n") && Contains("  Angle 4\n") && Contains("@27.5m@i27.5@0.993\\8.5"));
    CHECK(text.find("@27.5m@i27.5") == text.rfind("@27.5m@i27.5"));
    CHECK_THAT(text, Contains("order 5"));
}

TEST_CASE("Fractint's numbers have no signs and no exponents") {
    const std::string text =
        fractint_of("axiom: f(-0.000000125) -(-20) +(0) -(7) *(1000000000000000000) A\n" + stroke).bytes;
    CHECK_THAT(text, Contains("\\180@i8000000m@8000000/180\\20/7@1000000000000000000"));
    CHECK(text.find("e-") == std::string::npos);
}

TEST_CASE("A mirror is Fractint's own") {
    CHECK_THAT(fractint_of("axiom: | +(5) A\n" + stroke).bytes, Contains("!\\5[c1@10d]"));
}

TEST_CASE("Fractint's lines are short enough for every version") {
    std::string axiom = "axiom:";
    for (int k = 1; k < 200; ++k) axiom += " +(" + std::to_string(k) + ".5) f(" + std::to_string(k) + ") A";
    const std::string text = fractint_of(axiom + "\n" + stroke).bytes;
    std::size_t begin = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos; begin = end + 1, end = text.find('\n', begin))
        CHECK(end - begin <= 160);
}

TEST_CASE("A grammar of fragments only is refused") {
    CHECK_THROWS_AS(fractint_of("axiom: V\nterminal V: box 0 0 1 1; verbatim <<<SVG\n<text>x</text>\nSVG\n"), InputError);
}

TEST_CASE("A string with a closing bracket too many is refused") {
    CHECK_THROWS_WITH(fractint_of("axiom: [A] f(5) A]\n" + stroke), Contains("expected '['"));
}
