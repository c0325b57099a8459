// Regular layouts whose elements were shaken: what a person draws by hand.

#include <cmath>

#include "closed_loop/known_grammar.h"
#include "closed_loop/listed_scenes.h"

namespace rinceau::test {

namespace {

struct Layout {
    Recipe recipe;
    double spacing;  ///< the smallest
    std::vector<int> per_cent;
};

std::vector<Layout> layouts() {
    return {
        {{"facade",
          "axiom: U(2)\nU(m) : m > 0 -> [T(3)] f(51) U(m-1)\nT(m) : m > 0 -> [S(4)] +(90) f(52) -(90) T(m-1)\n"
          "S(m) : m > 0 -> [R(3)] +(90) f(10) -(90) S(m-1)\nR(m) : m > 0 -> [A] f(13) R(m-1)",
          {{"A", element(rectangle(7, 9), filled(sky))}}, 4, 4},
         10,
         {2, 5, 10, 15, 20}},
        {{"row", "axiom: P(14)\nP(m) : m > 0 -> [A] -(90) f(30) +(90) P(m-1)", {{"A", sized(hook(), 9, filled(ink))}}, 1, 1}, 30, {5, 10}},
        {{"grid",
          "axiom: Q(12)\nQ(n) : n > 0 -> [P(15)] f(40) Q(n-1)\nP(m) : m > 0 -> [A] -(90) f(40) +(90) P(m-1)",
          {{"A", sized(hook(), 12, filled(ink))}}, 2, 2},
         40,
         {5, 10}},
        {{"ring", "axiom: P(12)\nP(m) : m > 0 -> [f(40) A] +(30) P(m-1)", {{"A", sized(hook(), 6, filled(ink))}}, 1, 1}, 20.7, {2, 5, 10}},
        {{"rings", "axiom: Q(4)\nQ(n) : n > 0 -> [P(16, n)] Q(n-1)\nP(m, n) : m > 0 -> [f(20+20*n) A] +(22.5) P(m-1, n)",
          {{"A", element(circle(5), filled(gold))}}, 1, 2, 4},
         15.6,
         {2, 5, 10}},
    };
}

/// Every element moved by up to `share` of the spacing in x and in y, and turned by up to `share` radians.
Scene shaken(const Scene& scene, double share, double spacing, Random& random) {
    Scene result = scene;
    for (Element& element : result.elements) {
        const Point middle = center(bounds(element.paths));
        const Point shift{random.uniform(-share, share) * spacing, random.uniform(-share, share) * spacing};
        element = placed(element, translate(middle + shift) * rotate(random.uniform(-share, share)) * translate(Point{} - middle));
        result.viewport = including(result.viewport, painted_box(element));
    }
    return result;
}

}  // namespace

std::vector<ListedScene> noise_scenes() {
    constexpr int seeds = 20;
    std::vector<ListedScene> scenes;
    for (const Layout& layout : layouts()) {
        for (const int per_cent : layout.per_cent) {
            const Recipe& recipe = layout.recipe;
            scenes.push_back({"noise", recipe.name + "_shaken_" + std::to_string(per_cent), recipe.fewest_rules, recipe.most_rules,
                              recipe.axiom_symbols, 0, seeds, [=](std::uint64_t seed) {
                                  Random random(seed);
                                  return shuffled(shaken(drawn_scene(recipe), 0.01 * per_cent, layout.spacing, random), random);
                              }});
        }
    }
    return scenes;
}

}  // namespace rinceau::test
