#include "closed_loop/scenes.h"

#include <utility>

#include "closed_loop/known_grammar.h"
#include "closed_loop/recipe.h"
#include "geometry/random.h"

namespace rinceau::test {
namespace {

std::vector<Recipe> paper_figures() {
    const Element mark = sized(hook(), 12, filled(ink));
    return {
        {"fig8_sequence", "axiom: P(5)\nP(m) : m > 0 -> [A] +(7) f(50) +(7) P(m-1)", {{"A", mark}}, 1, 1},
        {"fig5_linear", "axiom: P(9, 60, -50)\nP(m, a, b) : m > 0 -> [A] +(a) f(50) +(b) P(m-1, a+10, b+10)", {{"A", mark}}, 1, 1},
        {"fig9_helix", "axiom: P(337)\nP(m) : m > 0 -> [A] f(27.5) *(0.993) +(8.5) P(m-1)", {{"A", mark}}, 1, 1},
        {"fig10_facade",
         "axiom: U(2)\nU(m) : m > 0 -> [T(3)] f(51) U(m-1)\nT(m) : m > 0 -> [S(4)] +(90) f(52) -(90) T(m-1)\n"
         "S(m) : m > 0 -> [R(3)] +(90) f(10) -(90) S(m-1)\nR(m) : m > 0 -> [A] f(13) R(m-1)",
         {{"A", element(rectangle(7, 9), filled(sky))}}, 4, 4},
    };
}

std::vector<Recipe> grids() {
    return {
        {"grid_20x30", "axiom: Q(20)\nQ(m) : m > 0 -> [P(30)] f(3) Q(m-1)\nP(m) : m > 0 -> [A] -(90) f(3) +(90) P(m-1)",
         {{"A", element(rectangle(2, 2), filled(clay))}}, 2, 2},
        {"grid_turning", "axiom: Q(12)\nQ(n) : n > 0 -> [P(15, 0)] -(90) f(40) +(90) Q(n-1)\nP(m, a) : m > 0 -> [+(a) A] f(40) P(m-1, a+7)",
         {{"A", sized(hook(), 12, filled(ink))}}, 2, 2},
        {"bricks",
         "axiom: Q(8)\nQ(n) : n > 0 -> [P(20)] [-(90) f(5) +(90) f(5) P(20)] f(10) Q(n-1)\nP(m) : m > 0 -> [A] -(90) f(10) +(90) P(m-1)",
         {{"A", element(rectangle(9, 4), filled(clay))}}, 2, 3},
        {"scales",
         "axiom: Q(6)\nQ(n) : n > 0 -> [P(21)] [-(90) f(5) +(90) -(180) f(6) +(180) P(21)] -(180) f(12) +(180) Q(n-1)\n"
         "P(m) : m > 0 -> [A] -(90) f(10) +(90) P(m-1)",
         {{"A", sized(leaf(0.6), 8, [] {
               Style style = filled(gold);
               style.stroke.paint = ink;
               style.stroke.width = 0.05;
               return style;
           }())}},
         2, 3, 1, true},
        {"facade_with_doors",
         "axiom: Q(8)\nQ(n) : n > 0 -> [P(12)] f(30) Q(n-1)\nP(m) : m > 0 -> [W] -(90) f(20) +(90) P(m-1)\nW -> A B\n"
         "except 1.1.3 -> D\nexcept 1.1.10 -> D",
         {{"A", element(rectangle(12, 20), filled(ink))}, {"B", element(rectangle(9, 16), filled(sky))},
          {"D", sized(hook(), 10, filled(clay))}},
         3, 3, 1, true},
        {"footprints", "axiom: P(20)\nP(m) : m > 0 -> [A] f(8) | P(m-1)",
         {{"A", element(transformed(transformed(hook(), scale_by(3)), translate({4, 0})), filled(ink))}}, 1, 1},
    };
}

std::vector<Recipe> rings() {
    const Element dot = element(circle(2), filled(sky));
    const Element small_leaf = sized(leaf(), 3, filled(gold));
    return {
        {"ring_chiral", "axiom: P(12)\nP(m) : m > 0 -> [f(40) A] +(30) P(m-1)", {{"A", sized(hook(), 6, filled(ink))}}, 1, 1},
        {"ring_circles", "axiom: P(12)\nP(m) : m > 0 -> [f(20) A] +(30) P(m-1)", {{"A", dot}}, 1, 1},
        {"rings_of_leaves", "axiom: Q(12)\nQ(n) : n > 0 -> [f(70) P(8)] +(30) Q(n-1)\nP(m) : m > 0 -> [f(10) A] +(45) P(m-1)",
         {{"A", small_leaf}}, 2, 2},
        {"rings_of_circles", "axiom: Q(12)\nQ(n) : n > 0 -> [f(70) P(8)] +(30) Q(n-1)\nP(m) : m > 0 -> [f(10) A] +(45) P(m-1)",
         {{"A", dot}}, 2, 2},
        {"mandala",
         "axiom: H P(16)\nP(m) : m > 0 -> [S] +(22.5) P(m-1)\n"
         "S -> [f(60) A] [f(76) B] [f(82) B] [f(88) B] [f(94) B] [f(100) B] [+(8) f(90) C] [| +(8) f(90) C]",
         {{"A", sized(leaf(), 10, filled(clay))}, {"B", element(circle(1.5), filled(gold))}, {"C", sized(hook(), 5, filled(ink))},
          {"H", element(regular_polygon(16, 20), filled(sky))}},
         2, 3, 2},
    };
}

Scene finished(const Scene& exact, bool shuffle, const KnownSceneOptions& options, Random& random) {
    Scene scene = options.rounding > 0 ? rounded(exact, options.rounding) : exact;
    return shuffle && options.shuffle ? shuffled(scene, random) : scene;
}

/// `count` copies of the types in random poses in the box, sizes 1/2 .. 2.
void add_clutter(Scene& scene, const std::vector<Element>& types, int count, const Box& where, Random& random) {
    for (int i = 0; i < count; ++i) {
        const Element& type = types[random.below(static_cast<std::uint32_t>(types.size()))];
        const double angle = random.uniform(-pi, pi);
        const double scale = std::exp2(random.uniform(-1, 1));
        const Point at{random.uniform(where.low.x, where.high.x), 0};
        const Similarity pose{polar(scale, angle), {at.x, random.uniform(where.low.y, where.high.y)}, random.below(2) == 1};
        scene.elements.push_back(placed(type, pose));
        scene.viewport = including(scene.viewport, painted_box(scene.elements.back()));
    }
}

std::string block_rules(int rows, int columns) {
    const std::string r = std::to_string(rows);
    const std::string c = std::to_string(columns);
    std::string rules = "axiom: [F1(" + r + ")] [-(90) f(" + std::to_string(columns * 560) + ") +(90) L1(" + r + ")] [-(90) f(" +
                        std::to_string(columns * 960) + ") +(90) K1(" + r + ")]\n";
    // Blocks of blocks: name, what is repeated, pitch up, pitch across.
    const auto blocks = [&](const std::string& name, const std::string& what, int up, int across) {
        if (rows * columns == 1) {
            rules += name + "1(m) -> " + what + "\n";
            return;
        }
        rules += name + "1(m) : m > 0 -> [" + name + "2(" + c + ")] f(" + std::to_string(up) + ") " + name + "1(m-1)\n";
        rules += name + "2(m) : m > 0 -> [" + what + "] -(90) f(" + std::to_string(across) + ") +(90) " + name + "2(m-1)\n";
    };
    blocks("F", "U(3)", 260, 520);
    blocks("L", "M(4)", 260, 330);
    blocks("K", "N(6)", 260, 330);
    return rules +
           "U(m) : m > 0 -> [T(4)] f(75) U(m-1)\nT(m) : m > 0 -> [S(8)] -(90) f(120) +(90) T(m-1)\n"
           "S(m) : m > 0 -> [R(5)] -(90) f(11) +(90) S(m-1)\nR(m) : m > 0 -> [A] f(12) R(m-1)\n"
           "M(m) : m > 0 -> [M2(5)] f(48) M(m-1)\nM2(m) : m > 0 -> [M3(12)] -(90) f(52) +(90) M2(m-1)\nM3(m) : m > 0 -> [f(16) B] +(30) M3(m-1)\n"
           "N(m) : m > 0 -> [N2(8)] f(34) N(m-1)\nN2(m) : m > 0 -> [N3(8)] -(90) f(37) +(90) N2(m-1)\nN3(m) : m > 0 -> [f(10) C] +(45) N3(m-1)";
}

}  // namespace

std::vector<KnownScene> known_scenes(const KnownSceneOptions& options) {
    Random random(options.seed);
    std::vector<KnownScene> scenes;
    for (const auto& family : {paper_figures(), grids(), rings()}) {
        for (const Recipe& recipe : family) {
            const Scene exact = drawn_scene(recipe);
            scenes.push_back({recipe.name, finished(exact, !recipe.order_shows, options, random), recipe.fewest_rules,
                              recipe.most_rules, recipe.axiom_symbols});
        }
    }
    for (const int count : {40, 500}) scenes.push_back(clutter_scene(count, options));
    return scenes;
}

KnownScene clutter_scene(int count, const KnownSceneOptions& options) {
    Random random(options.seed + static_cast<std::uint64_t>(count));
    const std::vector<Element> types{element(hook(), filled(ink)), element(leaf(), filled(gold)), element(star(5), filled(clay)),
                                     element(circle(0.8), filled(sky)), element(blob(6, random), filled(clay))};
    // One element in 49 squares of its size: few touch.
    const double side = 7 * std::sqrt(static_cast<double>(count));
    Scene scene;
    add_clutter(scene, types, count, {{0, 0}, {side, side}}, random);
    return {"clutter_" + std::to_string(count), finished(scene, false, options, random), 0, 0, count};
}

KnownScene nested_scene(int rows, int columns, const KnownSceneOptions& options) {
    Random random(options.seed);
    const int blocks = rows * columns;
    const std::vector<Element> types{element(rectangle(7, 9), filled(sky)), sized(leaf(), 3, filled(gold)), element(circle(2.5), filled(clay)),
                                     sized(hook(), 4, filled(ink))};
    Scene scene = drawn_scene(known_grammar(block_rules(rows, columns), {{"A", types[0]}, {"B", types[1]}, {"C", types[2]}}));
    const Point corner = scene.viewport.low;
    const double high = height(scene.viewport);
    add_clutter(scene, types, 96 * blocks, {corner - Point{300.0 * columns, 0}, corner + Point{-40, high}}, random);
    const int rules = blocks == 1 ? 10 : 16;
    return {"nested_" + std::to_string(scene.elements.size()), finished(scene, true, options, random), rules, 2 * rules, 3 + 96 * blocks};
}

}  // namespace rinceau::test
