// What grows along a sequence: the number of members, their distance, their size; and seeds in a flower.

#include "closed_loop/listed_scenes.h"

namespace rinceau::test {

namespace {

std::vector<Recipe> recipes() {
    const Element square = element(rectangle(3, 3), filled(clay));
    const Element mark = sized(hook(), 6, filled(ink));
    const Element seed = sized(leaf(0.5), 1.5, filled(gold));
    const std::string row = "P(m) : m > 0 -> [A] -(90) f(5) +(90) P(m-1)\n";
    return {
        {"triangle_of_rows", "axiom: T(12)\nT(m) : m > 0 -> [P(m)] f(5) T(m-1)\n" + row, {{"A", square}}, 2, 2},
        {"triangle_centred", "axiom: T(12)\nT(m) : m > 0 -> [P(m)] f(5) -(90) f(2.5) +(90) T(m-1)\n" + row, {{"A", square}}, 2, 2},
        {"pyramid_by_twos", "axiom: T(8)\nT(m) : m > 0 -> [P(2*m+1)] f(5) -(90) f(5) +(90) T(m-1)\n" + row, {{"A", square}}, 2, 2},
        {"rows_of_many_pitches",
         "axiom: [P(9, 10)] [f(30) P(7, 13)] [f(60) P(12, 11.5)] [f(90) P(8, 17)] [f(120) P(10, 14)]\n"
         "P(m, d) : m > 0 -> [A] -(90) f(d) +(90) P(m-1, d)",
         {{"A", square}}, 1, 1, 5},
        {"growing_distance", "axiom: P(15, 14)\nP(m, d) : m > 0 -> [A] -(90) f(d) +(90) P(m-1, d+2)", {{"A", mark}}, 1, 1},
        {"growing_size", "axiom: P(12)\nP(m) : m > 0 -> [*(0.5+0.1*m) A] -(90) f(24) +(90) P(m-1)", {{"A", mark}}, 1, 1},
        {"growing_distance_and_size", "axiom: P(14, 10)\nP(m, d) : m > 0 -> [*(0.4+0.1*(15-m)) A] -(90) f(d) +(90) P(m-1, d+2)", {{"A", mark}}, 1, 1},
        {"phyllotaxis_1000", "axiom: P(1000)\nP(m) : m > 0 -> [+(137.50776405*m) f(4*m^0.5) A] P(m-1)", {{"A", element(circle(1.5), filled(gold))}}, 1, 1},
        {"phyllotaxis_leaves_300", "axiom: P(300)\nP(m) : m > 0 -> [+(137.50776405*m) f(5*m^0.5) A] P(m-1)", {{"A", seed}}, 1, 1},
        {"phyllotaxis_exponential", "axiom: P(300)\nP(m) : m > 0 -> [f(24) A] +(137.50776405) *(0.99) P(m-1)", {{"A", seed}}, 1, 1},
        {"zigzag_bricks", "axiom: Q(16)\nQ(n) : n > 0 -> [-(90) f(2.5) +(90) P(20)] f(10) | Q(n-1)\nP(m) : m > 0 -> [A] -(90) f(10) +(90) P(m-1)",
         {{"A", element(rectangle(9, 4), filled(clay))}}, 2, 2},
    };
}

}  // namespace

std::vector<ListedScene> progress_scenes() {
    std::vector<ListedScene> scenes;
    for (const Recipe& recipe : recipes()) scenes.push_back(listed("progress", recipe));
    return scenes;
}

}  // namespace rinceau::test
