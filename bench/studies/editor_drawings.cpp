#include "editor_drawings.h"

#include <cmath>

#include "geometry/random.h"
#include "lsystem/grammar_text.h"

namespace rinceau {
namespace {

constexpr const char* head =
    "lsystem 1\ncanvas 0 0 1000 1000\nstyle 1: fill #3366cc\nstyle 2: fill #cc6633; stroke #000000; stroke-width 2\n"
    "terminal T: style 1; path \"M-1 -1L1 -1L1 1L-1 1Z\"\n";

EditorDrawing drawing(const std::string& name, const std::string& rules, const std::string& number) {
    return {name, parse_grammar(head + rules), number};
}

std::string grid_rules(int rows, int columns, const std::string& tile_string) {
    const std::string r = std::to_string(rows);
    const std::string c = std::to_string(columns);
    return "axiom: Grid(" + r + ")\nGrid(m) : m > 0 -> [Row(" + c + ")] f(10) Grid(m-1)\nRow(m) : m > 0 -> " + tile_string +
           " -(90) f(10) +(90) Row(m-1)\n";
}

std::string ring_rules(int rings, int count) {
    const std::string n = std::to_string(count);
    return "axiom: Rings(" + std::to_string(rings) + ")\nRings(m) : m > 0 -> [Ring(" + n +
           ")] f(30) Rings(m-1)\nRing(m) : m > 0 -> [f(12) T] +(360/" + n + ") Ring(m-1)\n";
}

std::string tree_rules(int levels) {
    return "axiom: Tree(" + std::to_string(levels) +
           ")\nTree(m) : m > 0 -> T f(20) [+(25) *(0.8) Tree(m-1)] -(25) *(0.8) Tree(m-1)\n";
}

std::string list_rules(int elements) {
    Random random(3);
    std::string text = "axiom:";
    for (int i = 0; i < elements; ++i)
        text += " [+(" + std::to_string(random.below(360)) + ") f(" + std::to_string(random.below(500)) + ") T]";
    return text + "\n";
}

std::string exceptions(int rows) {
    std::string text;
    for (int row = 1; row <= rows; row += 10) text += "except 1." + std::to_string(row) + ".3 -> ;(2) T\n";
    return text;
}

}  // namespace

std::vector<EditorDrawing> editor_drawings(int elements) {
    const int side = static_cast<int>(std::lround(std::sqrt(elements)));
    const int levels = static_cast<int>(std::lround(std::log2(elements)));
    constexpr int round = 20;
    std::vector<EditorDrawing> all;
    all.push_back(drawing("grid", grid_rules(side, side, "T"), "Row.count"));
    all.push_back(drawing("rings", ring_rules(elements / round, round), "Ring.count"));
    all.push_back(drawing("tree", tree_rules(levels), "Tree.levels"));
    all.push_back(drawing("list", list_rules(elements), "style2.stroke_width"));
    all.push_back(drawing("exceptions", grid_rules(side, side, "T") + exceptions(side), "Row.count"));
    all.push_back(drawing("layers", grid_rules(side, side, "T [z(1) ;(2) *(0.5) T]"), "Row.count"));
    all.push_back(drawing("noise", "seed 4\n" + grid_rules(side, side, "[+(normal(0, 5)) T]"), "Row.count"));
    return all;
}

}  // namespace rinceau
