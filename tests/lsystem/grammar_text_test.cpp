#include "lsystem/grammar_text.h"

#include <sstream>

#include <catch2/catch.hpp>

#include "random_grammar.h"

using namespace rinceau;

static const std::string example = R"(lsystem 1
title "Windows"

# drawn by hand
# for a test

canvas 0 0 640 480

define columns = 3
# a twelfth
define turn = 360/12

axiom: [+(30) f(120) P2(columns)] [f(3) A]

# row of 4 windows, upward
P1(m) : m > 0 -> [A] f(13) P1(m-1)
P2(m) : m > 0 -> [P1(4)] -(90) f(10) +(90) P2(m-1)

except 1.2.3 -> +(2) f(0.1) A
# gone
except 1.3.1 ->

style 1: fill #ffcc00; fill-rule evenodd; stroke #000000; stroke-width 2; stroke-linecap round

terminal A: style 1; path "M0-5L3 0L-3 0Z"; id "window"
terminal V1: box -4 -3 4 1; verbatim <<<SVG
<text>hi</text>
  # not a comment
SVG
)";

/// The place of the first mistake as "line:column".
static std::string fault_of(const std::string& text) {
    try {
        parse_grammar(text);
    } catch (const InputError& error) {
        return std::to_string(error.place().line) + ':' + std::to_string(error.place().column);
    }
    return "none";
}

TEST_CASE("a grammar is read as it is written") {
    const Grammar grammar = parse_grammar(example, "windows.lsys");
    CHECK(grammar.title == "Windows");
    CHECK(grammar.canvas == Box{{0, -480}, {640, 0}});
    CHECK(grammar.comments == std::vector<std::string>{"drawn by hand", "for a test"});
    REQUIRE(grammar.constants.size() == 2);
    CHECK(grammar.constants[1].comment == "a twelfth");
    CHECK(grammar.axiom.size() == 9);
    REQUIRE(grammar.productions.size() == 2);
    CHECK(grammar.productions[0].comment == "row of 4 windows, upward");
    CHECK(grammar.productions[0].place.line == 16);
    CHECK(grammar.productions[0].place.file == "windows.lsys");
    CHECK(grammar.productions[0].successor[4].symbol == "P1");
    CHECK(grammar.productions[0].successor[4].place.column == 28);
    REQUIRE(grammar.exceptions.size() == 2);
    CHECK(grammar.exceptions[0].address == std::vector<int>{1, 2, 3});
    CHECK(grammar.exceptions[1].successor.empty());
    CHECK(grammar.exceptions[1].comment == "gone");
    REQUIRE(grammar.terminals.size() == 2);
    CHECK(grammar.terminals[0].paths[0].start == Point{0, 5});  // y is turned up
    CHECK(grammar.terminals[0].id == "window");
    CHECK(grammar.terminals[1].verbatim == "<text>hi</text>\n  # not a comment");
    CHECK(grammar.terminals[1].verbatim_box == Box{{-4, -1}, {4, 3}});
}

TEST_CASE("a grammar in the writer's form is written as it was read") { CHECK(to_text(parse_grammar(example)) == example); }

TEST_CASE("line ends of other systems, a byte order mark and missing spaces change nothing but a fragment's bytes") {
    std::string text;
    for (const char c : example) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
    Grammar grammar = parse_grammar("\xEF\xBB\xBF" + text);
    CHECK(grammar.terminals[1].verbatim == "<text>hi</text>\r\n  # not a comment\r");
    grammar.terminals[1].verbatim = parse_grammar(example).terminals[1].verbatim;
    CHECK(same_grammar(grammar, parse_grammar(example)));
    const Grammar close = parse_grammar("lsystem 1\naxiom:[+(30)f(1)P(2)]A[-(3)|A]\nP(m):m>0->[A]f(1)P(m-1)");
    CHECK(to_text(close).find("axiom: [+(30) f(1) P(2)] A [-(3) | A]\n") != std::string::npos);
}

TEST_CASE("statements go on in indented lines, and their comments are kept") {
    const Grammar grammar = parse_grammar(
        "lsystem 1\n"
        "axiom: A   # in front\n"
        "  f(3\n"
        "  +1) A\n"
        "# before\n"
        "A -> B     # behind\n"
        "  # between\n"
        "  C\n"
        "terminal B: path \"M0 0\n"
        "  L1 1\"\n");
    CHECK(grammar.axiom.size() == 3);
    CHECK(to_text(grammar.axiom[1].arguments[0]) == "3+1");
    CHECK(grammar.axiom[2].place.line == 4);
    CHECK(grammar.axiom[2].place.column == 7);
    CHECK(grammar.comments == std::vector<std::string>{"in front"});
    CHECK(grammar.productions[0].comment == "before\nbehind\nbetween");
    CHECK(grammar.productions[0].successor.size() == 2);
    CHECK(grammar.terminals[0].paths[0].segments[0].to == Point{1, -1});
}

TEST_CASE("every module of a long string knows where it stands") {
    std::string text = "lsystem 1\naxiom:";
    for (int i = 0; i < 2000; ++i) text += i % 3 == 0 ? "\n   A(1,  2 + 3)" : i % 7 == 0 ? "\n # a note\n  B" : "  +( 30 ) C";
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    for (const ModuleTemplate& module : parse_grammar(text).axiom) {
        const std::string& line = lines.at(static_cast<std::size_t>(module.place.line) - 1);
        CHECK(line.substr(static_cast<std::size_t>(module.place.column) - 1, module.symbol.size()) == module.symbol);
    }
    CHECK(fault_of(text + "  %") == std::to_string(lines.size()) + ':' + std::to_string(lines.back().size() + 3));
}

TEST_CASE("styles read as in SVG, with y turned up") {
    const Grammar grammar = parse_grammar(
        "lsystem 1\n"
        "style 2: fill linear-gradient(matrix(1 2 3 4 5 6), spread reflect, 0 #f00, 1 navy opacity 0.5);\n"
        "  stroke gold; stroke-dasharray 3; pen 1 2 3 4; opacity 0.5; paint-order stroke\n"
        "style 3: fill none; shape-rendering crispEdges; stroke black; stroke-width 2 fixed\n");
    const Style& style = grammar.styles[0].style;
    const Gradient& gradient = *std::get<std::shared_ptr<const Gradient>>(style.fill);
    CHECK(gradient.map == Affine{1, -2, 3, -4, 5, -6});
    CHECK(gradient.stops[1].color == Color{0, 0, 128});
    CHECK(style.stroke.dashes == std::vector<double>{3, 3});
    CHECK(style.stroke.pen == Linear2{1, -2, -3, 4});
    CHECK(style.stroke_first);
    CHECK(std::holds_alternative<NoPaint>(grammar.styles[1].style.fill));
    CHECK(grammar.styles[1].style.crisp_edges);
    CHECK(grammar.styles[1].style.stroke.fixed);
    CHECK(grammar.styles[1].style.stroke.width == 2);
    CHECK_FALSE(style.stroke.fixed);
}

TEST_CASE("what is written reads back as the same grammar, and is written the same again") {
    Random random(3);
    for (int i = 0; i < 400; ++i) {
        const Grammar grammar = random_grammar(random);
        const std::string text = to_text(grammar);
        INFO(text);
        const Grammar again = parse_grammar(text);
        REQUIRE(same_grammar(again, grammar));
        REQUIRE(to_text(again) == text);
    }
}

TEST_CASE("canvases of any numbers keep them to the last bit") {
    Random random(4);
    for (int i = 0; i < 2000; ++i) {
        Grammar grammar;
        const Point low{random.uniform(-100, 100), random.uniform(-1e6, 1e6)};
        grammar.canvas = {low, {low.x + random.uniform(0, 1e3), low.y + random.uniform(0, 1e3)}};
        REQUIRE(parse_grammar(to_text(grammar)).canvas == grammar.canvas);
    }
}

TEST_CASE("a mistake is reported where it is") {
    const std::string top = "lsystem 1\n";
    CHECK(fault_of("") == "1:1");
    CHECK(fault_of("axiom: A") == "1:1");
    CHECK(fault_of("lsystem 2") == "1:9");
    CHECK(fault_of(top + "axiom: A $ B") == "2:10");
    CHECK(fault_of(top + "axiom: f(1") == "2:11");
    CHECK(fault_of(top + "axiom: A\naxiom: B") == "3:1");
    CHECK(fault_of(top + "P(m) : m > -> A") == "2:12");
    CHECK(fault_of(top + "P(m) : m > 0 A") == "2:15");
    CHECK(fault_of(top + "P(m, m) -> A") == "2:6");
    CHECK(fault_of(top + "f(m) -> A") == "2:1");
    CHECK(fault_of(top + "  A -> B") == "2:3");
    CHECK(fault_of(top + "except 1.0 -> A") == "2:10");
    CHECK(fault_of(top + "style 1: fil #fff") == "2:10");
    CHECK(fault_of(top + "style 1: fill #ggg") == "2:15");
    CHECK(fault_of(top + "style 1: opacity 2") == "2:18");
    CHECK(fault_of(top + "style 1: opacity 1; opacity 1") == "2:21");
    CHECK(fault_of(top + "terminal A: path \"M0 0") == "2:18");
    CHECK(fault_of(top + "terminal A: path \"M0 0L1\"") == "2:25");
    CHECK(fault_of(top + "terminal A: verbatim <<<SVG\nabc\n") == "2:22");
    CHECK(fault_of(top + "terminal A: style 1\nterminal A: style 2") == "3:10");
    CHECK(fault_of(top + "define a = 1\ndefine a = 2") == "3:8");
    CHECK(fault_of(top + "canvas 0 0 -1 5") == "2:12");
    CHECK(fault_of(top + "canvas 0 0 1e999 5") == "2:12");
}
