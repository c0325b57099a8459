// The commands fill and stroke: from the string to the picture.

#include <catch2/catch.hpp>

#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "lsystem/to_scene.h"
#include "scene/svg_read.h"

using namespace rinceau;

static const std::string terminals =
    "style 1: fill #ff0000; stroke #00ff00; stroke-width 2\n"
    "style 2: fill none; stroke #0000ff\n"
    "style 3: fill linear-gradient(matrix(1 0 0 1 0 0), 0 #ff0000, 1 #0000ff); stroke none\n"
    "terminal A: style 1; path \"M0 0H8V8Z\"\n"
    "terminal B: style 2; path \"M0 0H8V8Z\"\n"
    "terminal C: style 3; path \"M0 0H8V8Z\"\n"
    "terminal D: box 0 0 8 8; verbatim <<<SVG\n<text>D</text>\nSVG\n";

static Grammar grammar_of(const std::string& axiom) {
    return parse_grammar("lsystem 1\ncanvas -100 -100 200 200\naxiom: " + axiom + "\n" + terminals);
}

static std::vector<Element> elements_of(const std::string& axiom) {
    const Grammar grammar = grammar_of(axiom);
    return to_scene(grammar, interpret(grammar)).elements;
}

TEST_CASE("fill and stroke repaint what follows, until the bracket closes or they stand without numbers") {
    const std::vector<Element> elements = elements_of("[fill(1, 2, 3) A stroke(4, 5, 6) A fill A] A");
    REQUIRE(elements.size() == 4);
    const Color red{255, 0, 0}, green{0, 255, 0};
    CHECK(elements[0].style.fill == Paint(Color{1, 2, 3}));
    CHECK(elements[0].style.stroke.paint == Paint(green));
    CHECK(elements[1].style.fill == Paint(Color{1, 2, 3}));
    CHECK(elements[1].style.stroke.paint == Paint(Color{4, 5, 6}));
    CHECK(elements[2].style.fill == Paint(red));
    CHECK(elements[2].style.stroke.paint == Paint(Color{4, 5, 6}));
    CHECK(elements[3].style.fill == Paint(red));
    CHECK(elements[3].style.stroke.paint == Paint(green));
}

TEST_CASE("colours are rounded and brought into range") {
    CHECK(elements_of("fill(-20, 127.5, 1000) A").front().style.fill == Paint(Color{0, 128, 255}));
}

TEST_CASE("what paints nothing, gradients and fragments keep what they have") {
    const std::vector<Element> repainted = elements_of("fill(1, 2, 3) stroke(4, 5, 6) B C D ;(2) A");
    const std::vector<Element> plain = elements_of("B C D ;(2) A");
    CHECK(repainted[0].style.fill == Paint(NoPaint{}));
    CHECK(repainted[0].style.stroke.paint == Paint(Color{4, 5, 6}));
    CHECK(std::get<std::shared_ptr<const Gradient>>(repainted[1].style.fill)->stops ==
          std::get<std::shared_ptr<const Gradient>>(plain[1].style.fill)->stops);
    CHECK(repainted[1].style.stroke.paint == Paint(NoPaint{}));
    CHECK(repainted[2].verbatim == plain[2].verbatim);
    CHECK(repainted[3].style.fill == Paint(NoPaint{}));
    CHECK(repainted[3].style.stroke.paint == Paint(Color{4, 5, 6}));
}

TEST_CASE("the written picture has one definition for all colours, and reads back as the same scene") {
    const std::string axiom =
        "[fill(1, 2, 3) A] f(10) [fill(170, 187, 204) A] f(10) [A] f(10) [A] f(10) [fill(0, 0, 0) stroke(9, 9, 9) A] f(10) "
        "[stroke(7, 7, 7) B] f(10) [stroke(8, 8, 8) B] f(10) [fill(9, 9, 9) C] f(10) [fill(3, 3, 3) C] f(10) [fill(5, 5, 5) "
        "D]";
    const Grammar grammar = grammar_of(axiom);
    const std::vector<Placement> placements = interpret(grammar);
    const std::string svg = grammar_svg(grammar, placements);
    const auto count = [&](const std::string& part) {
        int found = 0;
        for (std::size_t at = svg.find(part); at != std::string::npos; at = svg.find(part, at + 1)) ++found;
        return found;
    };
    CHECK(count("id=\"lsystem-A-fill\"") == 1);
    CHECK(count("href=\"#lsystem-A-fill\"") == 2);
    CHECK(count("href=\"#lsystem-A\"") == 2);
    CHECK(count("href=\"#lsystem-B-stroke\"") == 2);
    CHECK(count("href=\"#lsystem-C\"") == 2);
    const Scene written = read_svg(svg).scene;
    const Scene scene = to_scene(grammar, placements);
    REQUIRE(written.elements.size() == scene.elements.size());
    for (std::size_t i = 0; i + 1 < scene.elements.size(); ++i) {
        if (i == 7 || i == 8) continue;  // gradients are mapped to the scene
        CHECK(written.elements[i].style.fill == scene.elements[i].style.fill);
        CHECK(written.elements[i].style.stroke.paint == scene.elements[i].style.stroke.paint);
        CHECK(written.elements[i].style.stroke.width == Approx(scene.elements[i].style.stroke.width));
    }
}

TEST_CASE("a picture coloured by rules shows these colours, not the commands'") {
    const Grammar grammar = grammar_of("fill(1, 2, 3) A A");
    const std::string svg = grammar_svg(grammar, interpret(grammar), {.color_by = ColorBy::terminal});
    CHECK(svg.find("#010203") == std::string::npos);
}
