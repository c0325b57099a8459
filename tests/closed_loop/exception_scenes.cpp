// Regular layouts in which something is missing, moved, or something else.

#include "closed_loop/listed_scenes.h"

namespace rinceau::test {

namespace {

std::string grid(int rows, int columns) {
    return "axiom: Q(" + std::to_string(rows) + ")\nQ(n) : n > 0 -> [P(" + std::to_string(columns) +
           ")] f(30) Q(n-1)\nP(m) : m > 0 -> [A] -(90) f(20) +(90) P(m-1)\n";
}

std::vector<Recipe> recipes() {
    const Element window = element(rectangle(12, 20), filled(sky));
    const Element mark = sized(hook(), 8, filled(ink));
    const Element door = sized(star(5), 9, filled(clay));
    return {
        {"grid_one_hole", grid(12, 12) + "except 1.5.7 ->", {{"A", window}}, 2, 2},
        {"grid_five_holes", grid(12, 12) + "except 1.2.2 ->\nexcept 1.2.9 ->\nexcept 1.6.6 ->\nexcept 1.11.3 ->\nexcept 1.12.12 ->", {{"A", window}}, 2, 2},
        {"grid_hole_of_four", grid(10, 10) + "except 1.5.5 ->\nexcept 1.5.6 ->\nexcept 1.6.5 ->\nexcept 1.6.6 ->", {{"A", window}}, 2, 2},
        {"grid_two_stand_ins", grid(8, 12) + "except 1.1.3 -> D\nexcept 1.1.10 -> D", {{"A", window}, {"D", door}}, 2, 2},
        {"facade_doors",
         "axiom: Q(8)\nQ(n) : n > 0 -> [P(12)] f(30) Q(n-1)\nP(m) : m > 0 -> [W] -(90) f(20) +(90) P(m-1)\nW -> A B\n"
         "except 1.1.3 -> D\nexcept 1.1.10 -> D",
         {{"A", element(rectangle(12, 20), filled(ink))}, {"B", element(rectangle(9, 16), filled(sky))}, {"D", sized(hook(), 10, filled(clay))}},
         3, 3, 1, true},
        {"keyboard_missing_key", grid(4, 14) + "except 1.2.8 ->", {{"A", window}}, 2, 2},
        {"half_row_at_border", grid(10, 12) + "except 1.10 -> P(6)", {{"A", window}}, 2, 2, 2},
        {"row_one_turned", "axiom: P(16)\nP(m) : m > 0 -> [A] -(90) f(20) +(90) P(m-1)\nexcept 1.7 -> +(15) A", {{"A", mark}}, 1, 1},
        {"row_one_hole", "axiom: P(16)\nP(m) : m > 0 -> [A] -(90) f(20) +(90) P(m-1)\nexcept 1.7 ->", {{"A", mark}}, 1, 1},
        {"ring_one_stand_in", "axiom: P(12)\nP(m) : m > 0 -> [f(50) A] +(30) P(m-1)\nexcept 1.4 -> D", {{"A", mark}, {"D", door}}, 1, 1},
        {"ring_one_hole", "axiom: P(12)\nP(m) : m > 0 -> [f(50) A] +(30) P(m-1)\nexcept 1.4 ->", {{"A", mark}}, 1, 1},
        {"rings_one_hole", "axiom: Q(12)\nQ(n) : n > 0 -> [f(90) P(8)] +(30) Q(n-1)\nP(m) : m > 0 -> [f(14) A] +(45) P(m-1)\nexcept 1.4.3 ->",
         {{"A", sized(hook(), 4, filled(ink))}}, 2, 2},
    };
}

}  // namespace

std::vector<ListedScene> exception_scenes() {
    std::vector<ListedScene> scenes;
    for (const Recipe& recipe : recipes()) scenes.push_back(listed("exceptions", recipe));
    return scenes;
}

}  // namespace rinceau::test
