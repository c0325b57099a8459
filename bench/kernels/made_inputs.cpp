#include "made_inputs.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "geometry/random.h"
#include "lsystem/grammar_text.h"
#include "lsystem/to_scene.h"
#include "tests/surface/surface_shapes.h"

namespace rinceau::bench {
namespace {

/// Gives the definition that the text has another value.
void define(std::string& text, const std::string& name, int value) {
    const std::string head = "define " + name + " = ";
    const std::size_t begin = text.find(head);
    if (begin == std::string::npos) throw std::runtime_error("no " + head + "in the drawing");
    const std::size_t number = begin + head.size();
    text.replace(number, text.find('\n', number) - number, std::to_string(value));
}

std::string drawing_text(const std::string& name) { return content_of(RINCEAU_BENCH_DRAWINGS "/" + name); }

}  // namespace

std::string content_of(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw std::runtime_error(file + " cannot be read");
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string ornament_text(int elements) {
    constexpr int in_a_sprig = 4;
    const int sprigs = std::max(1, elements / in_a_sprig);
    const int rows = std::max(1, static_cast<int>(std::sqrt(sprigs)));
    std::string text = drawing_text("ornament.lsys");
    define(text, "rows", rows);
    define(text, "columns", sprigs / rows);
    return text;
}

std::string clutter_text(int elements) {
    constexpr double area_of_one = 50 * 50;
    std::string text = drawing_text("clutter.lsys");
    define(text, "count", elements);
    define(text, "side", static_cast<int>(std::sqrt(area_of_one * elements)));
    return text;
}

Scene drawn(const std::string& grammar_text) {
    const Grammar grammar = parse_grammar(grammar_text);
    return to_scene(grammar, interpret(grammar));
}

std::vector<Point> strewn_points(int count) {
    Random random(1);
    std::vector<Point> points;
    for (int i = 0; i < count; ++i) {
        const double x = random.uniform();
        points.push_back({x, random.uniform()});
    }
    return points;
}

TriangleMesh torus_of(int faces) {
    constexpr double large = 1, small = 0.4;  // so that faces are about as wide as long: twice and a half as many around
    const int along = static_cast<int>(std::sqrt(faces / 5.0));
    return torus_triangles(faces / 2 / along, along, large, small);
}

}  // namespace rinceau::bench
