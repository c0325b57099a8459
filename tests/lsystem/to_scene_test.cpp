#include "lsystem/to_scene.h"

#include <catch2/catch.hpp>

#include "lsystem/grammar_text.h"
#include "scene/svg_path_data.h"
#include "scene/svg_read.h"
#include "scene/svg_transform.h"

using namespace rinceau;

static const std::string top = "lsystem 1\ncanvas -100 -100 200 200\n";
static const std::string looks =
    "style 1: fill #ffcc00; stroke black; stroke-width 2\n"
    "style 3: fill none; stroke black; stroke-width 2 fixed; stroke-dasharray 3 1\n"
    "terminal F: style 3; path \"M0 0H8\"\n"
    "style 2: fill linear-gradient(matrix(4 1 0 3 -2 1), 0 red, 1 blue); stroke green; pen 2 0.5 0 1\n"
    "terminal A: style 1; path \"M0-5L3 0L-3 0.25Z\"; id \"one\"\n"
    "terminal T: verbatim <<<SVG\n<text id=\"a\">hi</text>\nSVG\n";

static Grammar grammar_of(const std::string& axiom) { return parse_grammar(top + "axiom: " + axiom + "\n" + looks); }

static std::string svg_of(const Grammar& grammar, const GrammarSvgOptions& options = {}) {
    return grammar_svg(grammar, interpret(grammar, {.addresses = true}), options);
}

static std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

TEST_CASE("a placement's outline and stroke follow its pose") {
    const Grammar grammar = grammar_of("f(10) *(3) A [+(90) A]");
    const Scene scene = to_scene(grammar, interpret(grammar));
    CHECK(scene.viewport == grammar.canvas);
    REQUIRE(scene.elements.size() == 2);
    CHECK(abs(scene.elements[0].paths[0].start - Point{0, 25}) < 1e-12);
    CHECK(abs(scene.elements[1].paths[0].start - Point{-15, 10}) < 1e-12);
    CHECK(scene.elements[0].style.stroke.width == Approx(6));
    CHECK(scene.elements[0].id.empty());  // drawn twice
    CHECK(to_scene(grammar_of("A"), interpret(grammar_of("A"))).elements[0].id == "one");
}

TEST_CASE("a style of the string takes the place of the terminal's own") {
    const Grammar grammar = grammar_of("A [;(2) A ;(0) A]");
    const Scene scene = to_scene(grammar, interpret(grammar));
    CHECK(std::get<Color>(scene.elements[0].style.fill) == Color{255, 204, 0});
    CHECK(std::holds_alternative<std::shared_ptr<const Gradient>>(scene.elements[1].style.fill));
    CHECK(std::get<Color>(scene.elements[2].style.fill) == Color{255, 204, 0});
}

TEST_CASE("a fragment keeps its bytes under the pose's transform") {
    const Grammar grammar = grammar_of("T f(10) T");
    const Scene scene = to_scene(grammar, interpret(grammar));
    CHECK(scene.elements[0].verbatim == "<text id=\"a\">hi</text>");
    CHECK(scene.elements[1].verbatim.starts_with("<g transform=\""));
    CHECK(scene.elements[1].verbatim.find("<text id=\"a\">hi</text>") != std::string::npos);
}

TEST_CASE("what is drawn twice is defined once, what is drawn once stands in its place") {
    const std::string svg = svg_of(grammar_of("A f(1) A f(1) A f(1) ;(2) A f(1) T"));
    CHECK(count(svg, "<use ") == 3);
    CHECK(count(svg, "<path ") == 2);
    CHECK(count(svg, "<text ") == 1);
    CHECK(count(svg, "<linearGradient ") == 1);
    const std::string two = svg_of(grammar_of("T f(3) T"));
    CHECK(count(two, "<text ") == 1);
    CHECK(count(two, "<use ") == 2);
}

TEST_CASE("a fixed stroke is as wide as it says under every scale") {
    const Grammar grammar = grammar_of("[F] [*(4) F] f(7) *(0.25) [F] ;(3) A");
    const Scene scene = to_scene(grammar, interpret(grammar));
    for (const Element& element : scene.elements) {
        CHECK(element.style.stroke.width == 2);
        CHECK(element.style.stroke.dashes == std::vector<double>{3, 1});
        CHECK_FALSE(element.style.stroke.fixed);
    }
}

TEST_CASE("a use takes the width of a fixed stroke back by its scale, and equal ones stay with the definition") {
    const std::string svg = svg_of(grammar_of("[F] [*(4) F] *(0.25) F"));
    CHECK(count(svg, "<path ") == 1);
    CHECK(count(svg, "<use ") == 3);
    for (const char* lengths :
         {"stroke-width=\"2\" stroke-dasharray=\"3 1\"", "stroke-width=\"0.5\" stroke-dasharray=\"0.75 0.25\"",
          "stroke-width=\"8\" stroke-dasharray=\"12 4\""})
        CHECK(count(svg, lengths) == 1);
    const std::string one_scale = svg_of(grammar_of("*(4) F +(30) F f(3) F"));
    CHECK(count(one_scale, "stroke-width=\"0.5\"") == 1);
    CHECK(one_scale.find("stroke-width") < one_scale.find("</defs>"));
    CHECK(count(svg_of(grammar_of("*(4) F")), "stroke-width=\"0.5\"") == 1);
}

TEST_CASE("the picture with uses, read again, is the scene") {
    Grammar grammar = grammar_of("P(9)\nP(m) : m > 0 -> [F] +(20) f(9) *(0.8) | ;(3) A ;(0) P(m-1)");
    const std::vector<Placement> placements = interpret(grammar);
    const Scene expected = to_scene(grammar, placements);
    grammar.canvas = {{0, -200}, {200, 0}};  // which the reader leaves where it is
    const Scene read = read_svg(grammar_svg(grammar, placements)).scene;
    REQUIRE(read.elements.size() == expected.elements.size());
    for (std::size_t i = 0; i < read.elements.size(); ++i) {
        CHECK(abs(read.elements[i].paths[0].start - expected.elements[i].paths[0].start) < 1e-3);
        CHECK(same_style(read.elements[i].style, expected.elements[i].style, 1e-4));
    }
}

TEST_CASE("a use lies where the placement lies, to a ten-thousandth of a pixel") {
    const Grammar grammar =
        parse_grammar(top + "axiom: P(40)\nP(m) : m > 0 -> [A] +(7.7) f(9.1) *(0.95) +(3.3) | P(m-1)\n" + looks);
    const std::vector<Placement> placements = interpret(grammar);
    const std::string svg = grammar_svg(grammar, placements);
    std::size_t at = svg.find("</defs>");
    for (const Placement& placement : placements) {
        at = svg.find("<use ", at) + 1;
        const std::size_t start = svg.find("transform=\"", at);
        const std::size_t tag_end = svg.find("/>", at);
        std::string transform;
        if (start < tag_end) transform = svg.substr(start + 11, svg.find('"', start + 11) - start - 11);
        const Affine parsed = parse_transform_attribute(transform).map.value();
        for (const Point corner : {Point{0, 5}, Point{3, 0}, Point{-3, -0.25}}) {
            const Point expected = apply(placement.pose, corner);
            const Point drawn = apply(parsed, {corner.x, -corner.y});
            CHECK(abs(Point{drawn.x, -drawn.y} - expected) < 1e-4);
        }
    }
}

TEST_CASE("a stretched pen becomes a transform that leaves the outline where it was") {
    const Grammar grammar = grammar_of(";(2) A");
    const std::string svg = svg_of(grammar);
    const auto attribute = [&](const std::string& name) {
        const std::size_t start = svg.find(' ' + name + "=\"", svg.find("<path")) + name.size() + 3;
        return svg.substr(start, svg.find('"', start) - start);
    };
    const Affine stretch = parse_transform_attribute(attribute("transform")).map.value();
    const ParsedPath path = parse_path_data(attribute("d"));
    CHECK(stretch.a == Approx(2));
    CHECK(abs(apply(stretch, path.paths[0].start) - Point{0, -5}) < 1e-9);
    CHECK(abs(apply(stretch, path.paths[0].segments[1].to) - Point{-3, 0.25}) < 1e-9);
}

TEST_CASE("colours by rule, terminal or level replace paint and nothing else") {
    const Grammar grammar = parse_grammar(top + "axiom: A Q\nQ -> A f(1) A\n" + looks);
    CHECK(count(svg_of(grammar, {ColorBy::terminal}), "<path ") == 1);
    const std::string by_rule = svg_of(grammar, {ColorBy::rule});
    CHECK(count(by_rule, "<path ") == 2);
    CHECK(count(by_rule, "<use ") == 2);
    CHECK(by_rule.find("ffcc00") == std::string::npos);
    CHECK(by_rule.find("fc0") == std::string::npos);
    CHECK(count(by_rule, "stroke-width=\"2\"") == 2);
    CHECK(count(svg_of(grammar, {ColorBy::level}), "<path ") == 2);
}

TEST_CASE("a picture that is written as it is derived has the bytes of one made from a list") {
    const std::string drawn =
        "canvas 0 0 100 100\n"
        "style 1: fill red; stroke black; stroke-width 2 fixed\n"
        "style 2: fill linear-gradient(matrix(1 0 0 1 0 0), 0 red, 1 blue); stroke gold\n"
        "terminal A: style 1; path \"M0 0H1V1Z\"; id \"first\"\n"
        "terminal B: style 2; path \"M0 0H2V1Z\"; id \"second\"\n"
        "terminal C: box 0 -1 1 0; verbatim <<<SVG\n<text>c</text>\nSVG\n";
    const std::vector<std::string> strings{
        "axiom:\n", "axiom: A f(1) [z(2) B] f(1) +(30) [*(2) A] f(2) C z(-1) C\n",
        "axiom: R(5)\nR(n) : n > 0 -> [z(n) fill(10*n, 0, 0) A] f(1) [;(2) *(n) A] [z(-n) B] R(n-1)\n",  // many layers
        "axiom: R(5)\nR(n) : n > 0 -> [z(n % 2) +(uniform(0, 90)) A] f(normal(1, 0.1)) [C] R(n-1) : 1\nR(n) -> B : 1\n"};
    for (const std::string& string : strings) {
        const Grammar grammar = parse_grammar("lsystem 1\n" + drawn + string);
        for (const ColorBy color_by : {ColorBy::none, ColorBy::rule, ColorBy::terminal, ColorBy::level}) {
            const InterpretOptions derivation{.addresses = true};
            std::string written;
            write_grammar_svg(grammar, derivation, {.color_by = color_by},
                              [&](std::string_view piece) { written += piece; });
            CHECK(written == grammar_svg(grammar, interpret(grammar, derivation), {.color_by = color_by}));
        }
    }
}
