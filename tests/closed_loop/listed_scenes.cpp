#include "closed_loop/listed_scenes.h"

#include "closed_loop/known_grammar.h"
#include "closed_loop/scenes.h"

namespace rinceau::test {

namespace {

constexpr double rounding = 1e-3;  // of element sizes, as drawing programs write coordinates

ListedScene listed(const std::string& family, const KnownScene& known) {
    return {family, known.name, known.rules, known.most_rules, known.axiom_symbols, 0, 1,
            [scene = known.scene](std::uint64_t) { return scene; }};
}

ListedScene large_grid(int side) {
    const std::string n = std::to_string(side);
    const Recipe recipe{"grid_" + n + "x" + n,
                        "axiom: Q(" + n + ")\nQ(m) : m > 0 -> [P(" + n + ")] f(3) Q(m-1)\nP(m) : m > 0 -> [A] -(90) f(3) +(90) P(m-1)",
                        {{"A", element(rectangle(2, 2), filled(clay))}}, 2, 2};
    return listed("size", recipe);
}

}  // namespace

ListedScene listed(const std::string& family, const Recipe& recipe) {
    return {family, recipe.name, recipe.fewest_rules, recipe.most_rules, recipe.axiom_symbols, 0, 1, [recipe](std::uint64_t seed) {
                const Scene scene = rounded(drawn_scene(recipe), rounding);
                Random random(seed);
                return recipe.order_shows ? scene : shuffled(scene, random);
            }};
}

std::vector<ListedScene> listed_scenes(std::size_t largest) {
    std::vector<ListedScene> scenes;
    for (const KnownScene& known : known_scenes()) scenes.push_back(listed("ornament", known));
    for (const auto& family : {branching_scenes(), self_similar_scenes(), noise_scenes(), exception_scenes(), progress_scenes(),
                               style_scenes(), whole_scenes()}) {
        scenes.insert(scenes.end(), family.begin(), family.end());
    }
    for (const int count : {1'000, 10'000, 100'000}) {
        if (static_cast<std::size_t>(count) <= largest) scenes.push_back(listed("size", clutter_scene(count)));
    }
    for (const int side : {100, 316}) {
        if (static_cast<std::size_t>(side * side) <= largest) scenes.push_back(large_grid(side));
    }
    for (const auto& [rows, columns] : {std::pair{1, 1}, std::pair{2, 5}, std::pair{7, 12}}) {
        if (static_cast<std::size_t>(1200 * rows * columns) <= largest) scenes.push_back(listed("size", nested_scene(rows, columns)));
    }
    return scenes;
}

}  // namespace rinceau::test
