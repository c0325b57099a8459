#include "how_to/hpgl.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "lsystem/to_scene.h"

using namespace rinceau;

namespace {

constexpr double unit = 0.025 * 96 / 25.4;  // px

struct PenLine {
    int pen = 0;
    std::vector<Point> corners;  ///< px from the low left corner of the canvas
};

/// What a plotter would draw. Knows the instructions IN, SP, PU and PD alone.
std::vector<PenLine> plotted(const std::string& text) {
    std::vector<PenLine> lines;
    int pen = 0;
    std::istringstream instructions(text);
    for (std::string one; std::getline(instructions, one, ';');) {
        one.erase(0, one.find_first_not_of('\n'));
        if (one.empty()) continue;
        const std::string name = one.substr(0, 2);
        std::vector<double> numbers;
        std::istringstream arguments(one.substr(2));
        for (std::string number; std::getline(arguments, number, ',');) numbers.push_back(std::stod(number));
        REQUIRE((name == "IN" || name == "SP" || name == "PU" || name == "PD"));
        if (name == "SP") pen = static_cast<int>(numbers.at(0));
        if (name == "PU" && !numbers.empty()) lines.push_back({pen, {}});
        if (name == "PU" || name == "PD")
            for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
                lines.back().corners.push_back(Point{numbers[i], numbers[i + 1]} * unit);
    }
    return lines;
}

Grammar rules(const std::string& text) { return parse_grammar("lsystem 1\n" + text); }

constexpr const char* two_pens =
    "canvas -10 -40 60 50\naxiom: P(3)\nP(m) : m > 0 -> [+(20) A] [;(2) B] -(90) f(15) +(90) P(m-1)\n"
    "style 1: fill none; stroke #ff0000; stroke-width 3\nstyle 2: fill #0000ff\n"
    "terminal A: style 1; path \"M0 0C5 -9 9 -18 2 -30\"\nterminal B: style 2; path \"M0 0L4 0L2 -5Z\"";

double distance_to(const std::vector<Point>& corners, Point p) {
    double least = abs(p - corners.front());
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const Point way = corners[i] - corners[i - 1];
        const double along = norm(way) > 0 ? std::clamp(dot(p - corners[i - 1], way) / norm(way), 0.0, 1.0) : 0;
        least = std::min(least, abs(p - corners[i - 1] - way * along));
    }
    return least;
}

}  // namespace

TEST_CASE("a plotter draws what the grammar draws, to within a unit and a half, each colour with a pen of its own") {
    const Grammar grammar = rules(two_pens);
    const std::vector<PenLine> lines = plotted(to_hpgl(grammar).bytes);
    REQUIRE(lines.size() == 6);
    CHECK(std::ranges::count(lines, 1, &PenLine::pen) == 3);
    CHECK(std::ranges::count(lines, 2, &PenLine::pen) == 3);
    const Scene scene = to_scene(grammar, interpret(grammar));
    for (const Element& element : scene.elements) {
        std::vector<Point> wanted = flattened(element.paths.front(), unit / 10);
        if (element.paths.front().closed) wanted.push_back(wanted.front());
        for (Point& p : wanted) p = p - scene.viewport.low;
        const auto drawn = std::ranges::find_if(lines, [&](const PenLine& line) {
            return std::ranges::all_of(wanted, [&](Point p) { return distance_to(line.corners, p) < 1.5 * unit; }) &&
                   std::ranges::all_of(line.corners, [&](Point p) { return distance_to(wanted, p) < 1.5 * unit; });
        });
        CHECK(drawn != lines.end());
    }
}

TEST_CASE("what a plotter cannot draw is said, and nothing is refused") {
    CHECK(to_hpgl(rules(two_pens)).notes ==
          std::vector<std::string>{"HP-GL draws lines: fills are drawn as their outlines"});
    const Export dashed = to_hpgl(
        rules("axiom: A\nstyle 1: fill none; stroke black; stroke-dasharray 3 1\nterminal A: style 1; path \"M0 0L9 0\""));
    CHECK(dashed.notes == std::vector<std::string>{"HP-GL draws lines: dashes are drawn as whole lines"});
    CHECK_THROWS_AS(to_hpgl(rules("axiom: f(3)")), InputError);
}

TEST_CASE("a plotter with fewer pens than colours draws them all") {
    std::string text = "axiom:";
    for (int k = 0; k < 12; ++k) text += " f(9) stroke(" + std::to_string(20 * k) + ", 0, 0) A";
    const Export exported =
        to_hpgl(rules(text + "\nstyle 1: fill none; stroke black\nterminal A: style 1; path \"M0 0L5 0\""));
    const std::vector<PenLine> lines = plotted(exported.bytes);
    CHECK(lines.size() == 12);
    CHECK(std::ranges::all_of(lines, [](const PenLine& line) { return line.pen >= 1 && line.pen <= 8; }));
    CHECK(exported.notes.size() == 1);
}
