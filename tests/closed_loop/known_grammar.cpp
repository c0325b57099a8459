#include "closed_loop/known_grammar.h"

#include <cmath>

#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "lsystem/to_scene.h"

namespace rinceau::test {
namespace {

Element rounded(Element element, double grid) {
    const auto round = [&](Point& p) { p = {std::round(p.x / grid) * grid, std::round(p.y / grid) * grid}; };
    for (Path& path : element.paths) {
        round(path.start);
        for (Segment& segment : path.segments) {
            round(segment.control1);
            round(segment.control2);
            round(segment.to);
        }
    }
    return element;
}

}  // namespace

Grammar known_grammar(std::string_view rules, const std::vector<std::pair<std::string, Element>>& terminals) {
    Grammar grammar = parse_grammar("lsystem 1\n" + std::string(rules) + "\n", "known.lsys");
    for (const auto& [symbol, element] : terminals) {
        Terminal terminal{.symbol = symbol, .paths = element.paths, .verbatim = element.verbatim, .verbatim_box = element.verbatim_box};
        if (element.verbatim.empty()) {
            terminal.style = static_cast<int>(grammar.styles.size()) + 1;
            grammar.styles.push_back({.number = terminal.style, .style = element.style});
        }
        grammar.terminals.push_back(std::move(terminal));
    }
    return grammar;
}

Scene drawn_scene(const Grammar& grammar) {
    Scene scene = to_scene(grammar, interpret(grammar));
    scene.viewport = {};
    for (const Element& element : scene.elements) scene.viewport = including(scene.viewport, painted_box(element));
    return scene;
}

Scene shuffled(const Scene& scene, Random& random) {
    Scene result = scene;
    for (std::size_t i = result.elements.size(); i > 1; --i) {
        std::swap(result.elements[i - 1], result.elements[random.below(static_cast<std::uint32_t>(i))]);
    }
    return result;
}

Scene rounded(const Scene& scene, double share) {
    Scene result = scene;
    for (Element& element : result.elements) {
        const double size = diagonal(bounds(element.paths)) * share;
        if (size > 0) element = rounded(element, std::pow(10, std::floor(std::log10(size))));
    }
    return result;
}

}  // namespace rinceau::test
