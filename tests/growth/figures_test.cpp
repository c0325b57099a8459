// Figures: what a person counts as one thing, whatever it is drawn with.

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

#include "growth/arrangement/kinds.h"
#include "growth/arrangement/tile_of_drawing.h"
#include "growth/figures.h"
#include "lsystem/grammar_text.h"
#include "lsystem/to_scene.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

/// A stroke (A), a circle (C), a square (S), a filled disc (D), a wide bar (W), a line across the picture (B).
const std::string terminals = R"(
style 1: fill none; stroke #000000; stroke-width 0.3
style 2: fill #aa0000
terminal A: style 1; path "M-4 0L4 0"
terminal C: style 1; path "M3 0C3 1.66 1.66 3 0 3C-1.66 3-3 1.66-3 0C-3-1.66-1.66-3 0-3C1.66-3 3-1.66 3 0Z"
terminal S: style 1; path "M-1-1L1-1L1 1L-1 1Z"
terminal D: style 2; path "M1 0C1 0.55 0.55 1 0 1C-0.55 1-1 0.55-1 0C-1-0.55-0.55-1 0-1C0.55-1 1-0.55 1 0Z"
terminal G: style 2; path "M0 0L100 0L100 100L0 100Z"
terminal T: style 1; path "M-2-1.2L2-1.2L0 2.4Z"
)";

Grammar grammar_with(const std::string& axiom, const std::string& rules = "") {
    return parse_grammar("lsystem 1\ncanvas 0 0 100 100\naxiom: " + axiom + "\n" + rules + terminals, "drawing.svg");
}

/// "[..] body" at uneven places of a 4 x 4 grid, turned a little.
std::string scattered(const std::string& body, bool turned = true) {
    std::string axiom;
    for (int i = 0; i < 16; ++i) {
        const double up = 12.5 + 25 * (i / 4) + (i * 7 % 5) - 2;
        const double right = 12.5 + 25 * (i % 4) + (i * 3 % 5) - 2;
        axiom += "[f(" + std::to_string(up - 100) + ") -(90) f(" + std::to_string(right) + ") +(90)" +
                 (turned ? " +(" + std::to_string(i * 37) + ") " : " ") + body + "]\n ";
    }
    return axiom;
}

std::vector<std::size_t> copies(const FiguredDrawing& drawing) {
    std::vector<std::size_t> counts(drawing.figures.size());
    for (const FigureInstance& instance : drawing.instances) ++counts[static_cast<std::size_t>(instance.figure)];
    return counts;
}

using Counts = std::vector<std::size_t>;

/// Every part of every instance falls on what the grammar draws.
void check_poses(const Grammar& grammar, const FiguredDrawing& drawing) {
    std::vector<PlacedFigure> placed;
    for (const FigureInstance& instance : drawing.instances) placed.push_back({instance.figure, instance.pose, {}});
    const Scene again = to_scene(drawing.grammar, placements_of(drawing, placed));
    const Scene original = to_scene(grammar, interpret(grammar));
    REQUIRE(again.elements.size() == original.elements.size());
    for (const Element& element : original.elements) {
        const Box box = bounds(element.paths);
        CHECK(std::ranges::any_of(again.elements, [&](const Element& other) {
            const Box b = bounds(other.paths);
            return abs(b.low - box.low) + abs(b.high - box.high) < 0.1;
        }));
    }
}

}  // namespace

TEST_CASE("a shape inside another one, in its hole or drawn on its outline belongs to it") {
    const Grammar ringed = grammar_with(scattered("[C] [S]"));
    const FiguredDrawing drawing = figures_of(ringed);
    CHECK(copies(drawing) == Counts{16});
    CHECK(drawing.figures.front().symbol == "C+S");
    CHECK(drawing.figures.front().parts.size() == 2);
    check_poses(ringed, drawing);
    CHECK(figures_of(grammar_with(scattered("[C] [C] [D]"))).instances.size() == 16);
    const FiguredDrawing apart = figures_of(ringed, {.group = false});
    CHECK(copies(apart) == Counts{16, 16});
}

TEST_CASE("shapes that touch are one figure if their like do so everywhere, and not if they touch by chance") {
    const FiguredDrawing crosses = figures_of(grammar_with(scattered("[A] [+(90) A]")));
    CHECK(copies(crosses) == Counts{16});
    // sixteen bars, two of which are crossed by others
    const FiguredDrawing bars = figures_of(grammar_with(scattered("A") + "[f(-84) -(90) f(14) A] [f(-60) -(90) f(64) A]"));
    CHECK(bars.instances.size() == 18);
    CHECK(copies(bars) == Counts{18});
}

TEST_CASE("a net of touching shapes is no figure, but what a rule of the grammar draws in it is") {
    std::string squares;
    std::string cells;
    for (int i = 0; i < 30; ++i) {
        const std::string front = "[f(" + std::to_string(2 * (i / 6) - 60) + ") -(90) f(";
        squares += front + std::to_string(40 + 2 * (i % 6)) + ") +(90) S] ";
        cells += front + std::to_string(40 + 4 * (i % 6)) + ") +(90) Cell] ";
    }
    CHECK(figures_of(grammar_with(squares)).instances.size() == 30);
    // a square and a circle as wide side by side
    const FiguredDrawing pairs = figures_of(grammar_with(cells, "Cell -> [S] [-(90) f(2) +(90) *(0.33) C]\n"));
    CHECK(pairs.instances.size() == 30);
    CHECK(pairs.figures.front().parts.size() == 2);
}

TEST_CASE("strokes that the grammar pairs and that stand apart from others are one figure, rows of things are not") {
    const FiguredDrawing shells =
        figures_of(grammar_with(scattered("Pair(2)"), "Pair(m) : m > 0 -> [A] f(-1.6) +(180) | Pair(m-1)\n"));
    CHECK(copies(shells) == Counts{16});
    CHECK(shells.figures.front().symbol == "A");
    const std::string rows = "[f(-20) -(90) f(10) Row(6)] [f(-50) -(90) f(10) Row(6)] [f(-80) -(90) f(10) Row(6)]";
    CHECK(figures_of(grammar_with(rows, "Row(m) : m > 0 -> [D] f(14) Row(m-1)\n")).instances.size() == 18);
}

TEST_CASE("clusters of equal composition are figures also where the grammar says nothing") {
    const FiguredDrawing drawing = figures_of(grammar_with(scattered("[A] [f(1) A] [f(2) A]")));
    CHECK(copies(drawing) == Counts{16});
}

TEST_CASE("a raised symbol's expansions are figures, whatever they touch, and unknown ones are named") {
    const Grammar grammar = grammar_with(scattered("P"), "P -> [D] [f(8) Q]\nQ -> [S] [f(5) D]\n");
    const FiguredDrawing raised = figures_of(grammar, {.raised = {"P"}});
    CHECK(copies(raised) == Counts{16});
    CHECK(raised.figures.front().symbol == "P");
    CHECK(raised.figures.front().parts.size() == 3);
    check_poses(grammar, raised);
    CHECK(copies(figures_of(grammar, {.raised = {"Q", "P"}})) == Counts{16});
    CHECK(figures_of(grammar, {.raised = {"Q"}}).instances.size() == 32);
    CHECK_THROWS_WITH(figures_of(grammar, {.raised = {"X"}}),
                      Catch::Contains("'X' cannot be an element") && Catch::Contains("P, Q"));
    const FiguredDrawing one = figures_of(grammar, {.one_figure = true});
    CHECK(one.instances.size() == 1);
    CHECK(one.figures.front().parts.size() == 48);
}

TEST_CASE("copies keep their pose, mirror images among them, and other relations are other figures") {
    const Grammar grammar = grammar_with(
        "[f(-20) -(90) f(20) [C] [f(1) D]] [f(-60) -(90) f(60) +(50) *(1.5) | [C] [f(1) D]]"
        "[f(-20) -(90) f(80) [C] [f(2) D]]");
    const FiguredDrawing drawing = figures_of(grammar);
    CHECK(copies(drawing) == Counts{2, 1});
    CHECK(scale_of(drawing.instances[1].pose) / scale_of(drawing.instances[0].pose) == Approx(1.5));
    check_poses(grammar, drawing);
    CHECK(abs(center(bounds(drawing.figures[0].outline))) < 1e-6);
}

TEST_CASE("a background is no element, and what the picture's edge cuts is not whole") {
    const FiguredDrawing drawing = figures_of(grammar_with("[G] " + scattered("D") + " [f(-50) D]"));
    CHECK(drawing.instances.size() == 17);
    REQUIRE(drawing.warnings.size() == 1);
    CHECK_THAT(drawing.warnings.front(), Catch::Contains("G") && Catch::Contains("background"));
    CHECK(std::ranges::count_if(drawing.instances, &FigureInstance::whole) == 16);
}

TEST_CASE("a shape that only the picture's edge clips is made whole again and stands where it belongs") {
    const std::string clipped =
        "terminal V: box 0 49 1 51; verbatim <<<SVG\n<defs><clipPath id=\"c\"><path d=\"M0 0L100 0L100 100L0 "
        "100Z\"/></clipPath></defs>"
        "<g clip-path=\"url(#c)\"><circle cx=\"0\" cy=\"50\" r=\"1\" fill=\"#aa0000\"/></g>\nSVG\n";
    const FiguredDrawing drawing = figures_of(grammar_with(scattered("D") + " [V]", clipped));
    REQUIRE(drawing.instances.size() == 17);
    const FigureInstance& cut = drawing.instances.back();
    CHECK_FALSE(cut.whole);
    CHECK(abs(cut.pose.translation - Point{0, -50}) < 1e-6);
}

TEST_CASE("what is placed is drawn the same by placements and by a grammar, parts in colours of their own") {
    const Grammar grammar = grammar_with(scattered("[C] [fill(0, 0, 255) f(1) D]"));
    const FiguredDrawing drawing = figures_of(grammar);
    std::vector<PlacedFigure> placed;
    for (const FigureInstance& instance : drawing.instances) placed.push_back({instance.figure, instance.pose, {}});
    placed[3].repaints = {{.stroke = Color{0, 128, 0}}, {}};
    const Grammar grown = grammar_of(drawing, placed, {{0, -100}, {100, 0}});
    CHECK(grown.terminals.size() == 2);
    const Scene by_grammar = to_scene(grown, interpret(parse_grammar(to_text(grown))));
    const Scene by_placements = to_scene(drawing.grammar, placements_of(drawing, placed));
    REQUIRE(by_grammar.elements.size() == by_placements.elements.size());
    for (std::size_t i = 0; i < by_grammar.elements.size(); ++i) {
        CHECK(same_style(by_grammar.elements[i].style, by_placements.elements[i].style, 1e-9));
        const Box a = bounds(by_grammar.elements[i].paths);
        const Box b = bounds(by_placements.elements[i].paths);
        CHECK(abs(a.low - b.low) + abs(a.high - b.high) < 1e-9);
    }
}

TEST_CASE("elements are sorted into kinds by figure, size and stance, and rare figures by what paints them") {
    const auto names = [](const std::string& axiom) { return element_kinds(figures_of(grammar_with(axiom))).names; };
    CHECK(names(scattered("D")) == std::vector<std::string>{"D"});
    CHECK(names(scattered("D") + "[f(-25) -(90) f(25) *(3) D] [f(-75) -(90) f(25) *(3) D] [f(-25) -(90) f(75) *(3) D]")
              .size() == 2);
    // upright and upside down
    CHECK(names("[f(-20) [-(90) f(20) T] [-(90) f(40) T] [-(90) f(60) T] [-(90) f(80) T]]"
                "[f(-50) [-(90) f(20) +(180) T] [-(90) f(40) +(180) T] [-(90) f(60) +(180) T] [-(90) f(80) +(180) T]]") ==
          std::vector<std::string>{"T", "T.2"});
    CHECK(names(scattered("T")).size() == 1);
    // six different groups of strokes, and one of discs
    const std::string stones =
        "[f(-20) -(90) f(20) T] [f(-20) -(90) f(50) *(0.8) C] [f(-20) -(90) f(80) *(1.5) S]"
        "[f(-60) -(90) f(20) *(1.3) T] [f(-60) -(90) f(50) C] [f(-60) -(90) f(80) D]";
    CHECK(names(stones).size() == 2);
}

TEST_CASE("a drawing whose edges go on at the opposite ones is a tile, and its cut elements are one each") {
    const auto at = [](double x, double y, const std::string& body) {
        return "[f(" + std::to_string(y - 100) + ") -(90) f(" + std::to_string(x) + ") +(90) " + body + "] ";
    };
    const std::string inside = scattered("D");
    const std::string twins = at(0, 25, "D") + at(100, 25, "D") + at(50, 0, "D") + at(50, 100, "D");
    const FiguredDrawing drawing = figures_of(grammar_with(inside + twins));
    CHECK_FALSE(evident_tile(figures_of(grammar_with(inside))));
    CHECK_FALSE(evident_tile(figures_of(grammar_with(inside + at(0, 25, "D") + at(100, 70, "D") + at(50, 0, "D")))));
    REQUIRE(evident_tile(drawing));
    const FiguredDrawing tile = as_tile(drawing, *evident_tile(drawing));
    CHECK(tile.instances.size() == 18);
    CHECK(std::ranges::all_of(tile.instances, &FigureInstance::whole));
    // whole squares that end at both edges are no pieces
    std::string wall;
    for (int i = 1; i < 10; ++i) wall += at(1, 10 * i, "S") + at(99, 10 * i, "S") + at(50, 10 * i, "S");
    CHECK_FALSE(evident_tile(figures_of(grammar_with(wall))));
    // bars that the edge has cut in two: each piece ends a little beyond the edge
    const std::string pieces =
        at(2.4, 25, "+(0) *(0.625) A") + at(98.6, 25, "*(0.375) A") + at(1.4, 60, "*(0.375) A") + at(97.6, 60, "*(0.625) A");
    const FiguredDrawing cut = figures_of(grammar_with(scattered("A", false) + pieces));
    REQUIRE(evident_tile(cut));
    const FiguredDrawing joined = as_tile(cut, *evident_tile(cut));
    CHECK(joined.instances.size() == 18);
    for (const FigureInstance& instance : joined.instances) {
        const Figure& figure = joined.figures[static_cast<std::size_t>(instance.figure)];
        if (figure.parts.size() < 2) continue;
        CHECK(instance.whole);
        CHECK(figure.radius == Approx(4).epsilon(0.05));
    }
}

}  // namespace rinceau
