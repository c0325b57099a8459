#include "lsystem/to_scene.h"

#include <map>

#include "lsystem/drawn_style.h"
#include "lsystem/style_table.h"
#include "scene/svg_write.h"

namespace rinceau {

namespace {

Box moved(const Box& box, const Similarity& pose) {
    if (is_empty(box)) return box;
    Box result;
    for (const Point corner : {box.low, box.high, Point{box.low.x, box.high.y}, Point{box.high.x, box.low.y}}) {
        result = including(result, apply(pose, corner));
    }
    return result;
}

std::string moved_fragment(const std::string& fragment, const Similarity& pose) {
    const std::string transform = svg_transform_text(to_affine(pose));
    if (transform.empty()) return fragment;
    return "<g transform=\"" + transform + "\">" + fragment + "</g>";
}

Element placed_element(const Grammar& grammar, const StyleTable& styles, const Placement& placement) {
    const Terminal& terminal = grammar.terminals[static_cast<std::size_t>(placement.terminal)];
    Element element;
    if (!terminal.verbatim.empty()) {
        element.verbatim = moved_fragment(terminal.verbatim, placement.pose);
        element.verbatim_box = moved(terminal.verbatim_box, placement.pose);
        return element;
    }
    element.paths = transformed(terminal.paths, placement.pose);
    const Style& style = styles.style(drawn_style_number(grammar, placement));
    element.style = transformed(repainted(style, placement.repaint), placement.pose);
    element.style.stroke.fixed = false;
    return element;
}

}  // namespace

Scene to_scene(const Grammar& grammar, const std::vector<Placement>& placements) {
    // an id stands for one thing of the picture
    std::map<std::string, int> uses;
    for (const Placement& placement : placements) ++uses[grammar.terminals[static_cast<std::size_t>(placement.terminal)].id];
    const StyleTable styles(grammar);
    Scene scene;
    scene.viewport = grammar.canvas;
    scene.sized = grammar.sized;
    scene.elements.reserve(placements.size());
    for (const Placement& placement : placements) {
        Element element = placed_element(grammar, styles, placement);
        const std::string& id = grammar.terminals[static_cast<std::size_t>(placement.terminal)].id;
        if (!id.empty() && uses[id] == 1) element.id = id;
        scene.elements.push_back(std::move(element));
    }
    return scene;
}

}  // namespace rinceau
