#include "closed_loop/noisy_scenes.h"

#include <algorithm>
#include <cmath>

#include "closed_loop/known_grammar.h"
#include "closed_loop/shapes.h"

namespace rinceau::test {

namespace {

struct Recipe {
    std::string name;
    std::string grammar;
    Element terminal;
    double spacing;
    std::string rules;
};

std::vector<Recipe> recipes() {
    const Element window = element(rectangle(7, 9), filled({200, 220, 240}));
    const Element petal = element(transformed(hook(), scale_by(6)), filled({90, 60, 40}));
    const Element small = element(transformed(leaf(), scale_by(3)), filled({200, 160, 40}));
    const Element dot = element(circle(2), filled({60, 90, 160}));
    return {
        {"fig10_facade",
         "axiom: U(2)\nU(m) : m > 0 -> [T(3)] f(51) U(m-1)\nT(m) : m > 0 -> [S(4)] +(90) f(52) -(90) T(m-1)\n"
         "S(m) : m > 0 -> [R(3)] +(90) f(10) -(90) S(m-1)\nR(m) : m > 0 -> [A] f(13) R(m-1)",
         window, 10, "sequence of 2; sequence of 3; sequence of 3; sequence of 4"},
        {"grid_12x15", "axiom: Q(12)\nQ(m) : m > 0 -> [P(15)] f(14) Q(m-1)\nP(m) : m > 0 -> [A] -(90) f(14) +(90) P(m-1)", window, 14,
         "sequence of 12; sequence of 15"},
        {"ring_12", "axiom: P(12)\nP(m) : m > 0 -> [f(40) A] +(30) P(m-1)", petal, 20.7, "ring of 12"},
        {"rings_12x8", "axiom: Q(12)\nQ(n) : n > 0 -> [f(70) P(8)] +(30) Q(n-1)\nP(m) : m > 0 -> [f(10) A] +(45) P(m-1)", small,
         7.65, "ring of 12; ring of 8"},
        {"staggered_rows",
         "axiom: Q(4)\nQ(n) : n > 0 -> [P(10)] [-(90) f(8) +(90) f(9) P(10)] f(18) Q(n-1)\nP(m) : m > 0 -> [A] -(90) f(16) +(90) P(m-1)",
         dot, 12, "sequence of 10; sequence of 2; sequence of 4"},
        {"circles_8x10", "axiom: Q(8)\nQ(m) : m > 0 -> [P(10)] f(9) Q(m-1)\nP(m) : m > 0 -> [A] -(90) f(9) +(90) P(m-1)", dot, 9,
         "sequence of 10; sequence of 8"},
        {"polar_3x12",
         "axiom: [P(12)] [Q(12)] [R(12)]\nP(m) : m > 0 -> [f(40) A] +(30) P(m-1)\nQ(m) : m > 0 -> [f(60) A] +(30) Q(m-1)\n"
         "R(m) : m > 0 -> [f(80) A] +(30) R(m-1)",
         petal, 20, "ring of 12; sequence of 3"},
    };
}

}  // namespace

NoisyScene noisy_scene(const std::string& name, double jitter, std::uint64_t seed) {
    const std::vector<Recipe> all = recipes();
    const Recipe& recipe = *std::ranges::find(all, name, &Recipe::name);
    NoisyScene scene;
    scene.regular = drawn_scene(known_grammar(recipe.grammar, {{"A", recipe.terminal}}));
    scene.rules = recipe.rules;
    scene.spacing = recipe.spacing;
    scene.drawn = scene.regular;
    Random random(seed);
    scene.drawn.viewport = {};
    for (Element& each : scene.drawn.elements) {
        const Point middle = center(bounds(each.paths));
        const double shift = jitter * recipe.spacing;
        const double x = random.uniform(-shift, shift), y = random.uniform(-shift, shift);
        each = placed(each, translate(middle + Point{x, y}) * rotate(random.uniform(-jitter, jitter)) * translate(-middle));
        scene.drawn.viewport = including(scene.drawn.viewport, painted_box(each));
    }
    return scene;
}

std::vector<std::string> noisy_scene_names() {
    std::vector<std::string> names;
    for (const Recipe& recipe : recipes()) names.push_back(recipe.name);
    return names;
}

Scene drawn_in_order_of(const Scene& wanted, const Scene& scene) {
    Scene ordered = scene;
    ordered.elements.clear();
    for (const Element& place : wanted.elements) {
        const Point middle = center(bounds(place.paths));
        ordered.elements.push_back(*std::ranges::min_element(
            scene.elements, {}, [&](const Element& each) { return abs(center(bounds(each.paths)) - middle); }));
    }
    return ordered;
}

double rms_distance(const Scene& a, const Scene& b) {
    double squares = 0;
    for (std::size_t i = 0; i < a.elements.size(); ++i) {
        squares += norm(center(bounds(a.elements[i].paths)) - center(bounds(b.elements[i].paths)));
    }
    return std::sqrt(squares / static_cast<double>(a.elements.size()));
}

}  // namespace rinceau::test
