// Trees (Stava et al. 2010, section 5.2, r3 and r4; Figure 1).

#include "closed_loop/known_grammar.h"
#include "closed_loop/listed_scenes.h"

namespace rinceau::test {

namespace {

/// Figure 1: the stem, bent to one side.
Element stem() {
    Style style = stroked(clay, 14);
    style.stroke.cap = LineCap::round;
    return element({Path{.start = {0, 0}, .segments = {curve_to({36, 48}, {20, 115}, {-22, 180})}}}, style);
}

constexpr const char* figure_1 = "R(m) : m > 0 -> A [-(17) f(64) *(0.8) -(3) R(m-1)] [+(7) f(181) *(0.6) +(23) R(m-1)]\n";

Recipe figure_1_of(int depth) {
    return {"fig1_branching_" + std::to_string(depth), "axiom: R(" + std::to_string(depth) + ")\n" + figure_1, {{"A", stem()}}, 1, 1};
}

std::vector<Recipe> recipes() {
    const Element mark = sized(hook(), 12, filled(ink));
    const Element dot = element(circle(5), filled(gold));
    const std::string two = "[+(25) f(60) *(0.7) R(m-1)] [-(40) f(45) *(0.6) R(m-1)]";
    std::vector<Recipe> made;
    for (const int depth : {3, 4, 5, 6, 7, 8, 9, 10}) made.push_back(figure_1_of(depth));
    made.push_back({"branching_leaves", "axiom: R(6)\nR(m) : m > 0 -> A " + two + "\nR(m) : m == 0 -> B", {{"A", mark}, {"B", dot}}, 1, 2});
    made.push_back({"branching_levels",
                    "axiom: R(7)\nR(m) : m > 0 && m % 2 == 0 -> A " + two + "\nR(m) : m > 0 && m % 2 == 1 -> B " + two,
                    {{"A", mark}, {"B", dot}}, 1, 2});
    made.push_back({"branching_groups", "axiom: R(6)\nR(m) : m > 0 -> N " + two + "\nN -> A [f(-20) B]", {{"A", mark}, {"B", dot}}, 2, 2});
    made.push_back({"fern", "axiom: R(7)\nR(m) : m > 0 -> A [f(50) *(0.8) +(5) R(m-1)] [f(14) +(60) f(16) *(0.4) R(m-1)] [f(14) -(60) f(16) *(0.4) R(m-1)]",
                    {{"A", sized(leaf(0.3), 12, filled(clay))}}, 1, 1});
    made.push_back({"binary_tree_of_lines", "axiom: R(9)\nR(m) : m > 0 -> A [f(20) +(30) *(0.7) R(m-1)] [f(20) -(30) *(0.7) R(m-1)]",
                    {{"A", element(transformed(bar(), scale_by(10) * translate({0, 1})), stroked(ink, 1))}}, 1, 1});
    made.push_back({"tree_of_equal_sizes", "axiom: R(8)\nR(m) : m > 0 -> A [+(21) f(24) R(m-1)] [-(34) f(20) R(m-1)]",
                    {{"A", element(transformed(bar(), scale_by(9) * translate({0, 1})), stroked(ink, 1))}}, 1, 1});
    return made;
}

/// Twenty trees of depths 5 and 6 in random places and angles.
Scene forest(std::uint64_t seed) {
    Random random(seed);
    std::string axiom = "axiom:";
    for (int k = 0; k < 20; ++k) {
        const auto number = [&](double low, double high) { return std::to_string(random.uniform(low, high)); };
        axiom += " [-(90) f(" + std::to_string(900 * (k % 5)) + ") +(90) f(" + std::to_string(900 * (k / 5)) + ") +(" +
                 number(-30, 30) + ") *(" + number(0.7, 1.3) + ") R(" + std::to_string(5 + k % 2) + ")]";
    }
    return rounded(drawn_scene(known_grammar(axiom + "\n" + figure_1, {{"A", stem()}})), 1e-3);
}

/// A tree of 255 among 255 copies of its element that belong to nothing.
Scene tree_in_clutter(std::uint64_t seed) {
    Random random(seed);
    Scene scene = drawn_scene(figure_1_of(8));
    for (int k = 0; k < 255; ++k) {
        const double size = std::exp2(random.uniform(-5, -1));
        const Point at{random.uniform(400, 1400), random.uniform(-400, 600)};
        scene.elements.push_back(placed(stem(), {polar(size, random.uniform(-pi, pi)), at, random.below(2) == 1}));
        scene.viewport = including(scene.viewport, painted_box(scene.elements.back()));
    }
    return shuffled(rounded(scene, 1e-3), random);
}

}  // namespace

std::vector<ListedScene> branching_scenes() {
    std::vector<ListedScene> scenes;
    for (const Recipe& recipe : recipes()) scenes.push_back(listed("branching", recipe));
    scenes.push_back({"branching", "forest_20", 1, 1, 20, 0, 1, forest});
    scenes.push_back({"branching", "tree_in_clutter", 1, 1, 256, 0, 1, tree_in_clutter});
    return scenes;
}

}  // namespace rinceau::test
