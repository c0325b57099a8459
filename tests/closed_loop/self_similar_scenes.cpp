// Curves and plants that are made of smaller copies of themselves, drawn in one go.

#include "closed_loop/known_grammar.h"
#include "closed_loop/listed_scenes.h"

namespace rinceau::test {

namespace {

/// From the turtle one unit ahead.
Element stroke_ahead() {
    Style style = stroked(ink, 0.08);
    style.stroke.cap = LineCap::round;
    return element({Path{.start = {0, 0}, .segments = {line_to({0, 1})}}}, style);
}

/// Rules of one letter a curve: F stands for F(n-1), "L" for L(n-1) .., "|" for a step; + and - turn by the angle.
std::string curve(const std::string& start, double angle, const std::vector<std::pair<char, std::string>>& rules) {
    std::string text = "axiom: " + start + "\n";
    for (const auto& [symbol, body] : rules) {
        const std::string name(1, symbol);
        text += name + "(n) : n > 0 ->";
        for (const char c : body) {
            if (c == '+' || c == '-') {
                text += std::string(" ") + c + "(" + std::to_string(angle) + ")";
            } else if (c == '|') {
                text += " A f(1)";
            } else if (c == '[' || c == ']') {
                text += std::string(" ") + c;
            } else {
                text += std::string(" ") + c + "(n-1)";
            }
        }
        text += "\n";
        if (body.find('|') == std::string::npos) text += name + "(n) : n == 0 -> A f(1)\n";
    }
    return text;
}

std::vector<Recipe> curves() {
    const std::vector<std::pair<std::string, Element>> line{{"A", stroke_ahead()}};
    // The rule and its end.
    const auto of = [&](const char* name, const std::string& rules, int most = 2) { return Recipe{name, rules, line, 1, most, 1, true}; };
    Recipe lost = of("koch_order_lost", curve("F(4)", 60, {{'F', "F+F--F+F"}}));
    lost.order_shows = false;
    return {
        of("koch", curve("F(4)", 60, {{'F', "F+F--F+F"}})),
        lost,
        of("koch_quadratic", curve("F(3)", 90, {{'F', "F+F-F-FF+F+F-F"}})),
        of("hilbert", curve("L(4)", 90, {{'L', "+R|-L|L-|R+"}, {'R', "-L|+R|R+|L-"}}), 2),
        of("dragon", curve("X(8)", 90, {{'X', "X+Y"}, {'Y', "X-Y"}}), 2),
        of("gosper", curve("X(3)", 60, {{'X', "X-Y--Y+X++XX+Y-"}, {'Y', "+X-YY--Y-X++X+Y"}}), 2),
        of("arrowhead", curve("X(5)", 60, {{'X', "Y-X-Y"}, {'Y', "X+Y+X"}}), 2),
        of("levy", curve("F(8)", 45, {{'F', "+F--F+"}})),
        of("plant_bracketed", curve("F(4)", 25.7, {{'F', "F[+F]F[-F]F"}})),
        of("plant_bush", curve("F(3)", 22.5, {{'F', "FF-[-F+F+F]+[+F-F-F]"}})),
    };
}

/// Squares of squares: of 3 x 3 places those in `places` are filled, each again.
std::string squares(int depth, const std::string& places) {
    std::string text = "axiom: S(" + std::to_string(depth) + ")\nS(n) : n > 0 ->";
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (places[k] != 'x') continue;
        text += " [f(" + std::to_string(k / 3) + "*3^(n-1)) -(90) f(" + std::to_string(k % 3) + "*3^(n-1)) +(90) S(n-1)]";
    }
    return text + "\nS(n) : n == 0 -> A";
}

std::vector<Recipe> sets() {
    const Element square = element(rectangle(0.9, 0.9), filled(sky));
    return {
        {"cantor_dust", squares(4, "x.x...x.x"), {{"A", square}}, 1, 2},
        {"carpet", squares(3, "xxxx.xxxx"), {{"A", square}}, 1, 2},
        {"triangles", "axiom: S(5)\nS(n) : n > 0 -> [S(n-1)] [-(30) f(2^(n-1)) +(30) S(n-1)] [+(30) f(2^(n-1)) -(30) S(n-1)]\nS(n) : n == 0 -> A",
         {{"A", element(regular_polygon(3, 0.5), filled(clay))}}, 1, 2},
    };
}

}  // namespace

std::vector<ListedScene> self_similar_scenes() {
    std::vector<ListedScene> scenes;
    for (const auto& recipes : {curves(), sets()}) {
        for (const Recipe& recipe : recipes) scenes.push_back(listed("self-similar", recipe));
    }
    return scenes;
}

}  // namespace rinceau::test
