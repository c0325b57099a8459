#include "lsystem/drawing_terminals.h"

#include <algorithm>

#include "lsystem/fit_box.h"
#include "lsystem/grammar_names.h"
#include "lsystem/number_text.h"
#include "lsystem/style_text.h"
#include "scene/svg_write.h"

namespace rinceau {

namespace {

Box corners_moved(const Box& box, const Similarity& map) {
    Box result;
    if (is_empty(box)) return result;
    for (const Point corner : {box.low, box.high, Point{box.low.x, box.high.y}, Point{box.high.x, box.low.y}})
        result = including(result, apply(map, corner));
    return result;
}

Point rounded(Point p, double size) { return {rounded_in(p.x, size), rounded_in(p.y, size)}; }

std::vector<Path> rounded(std::vector<Path> paths, double size) {
    for (Path& path : paths) {
        path.start = rounded(path.start, size);
        for (Segment& segment : path.segments) {
            segment.control1 = rounded(segment.control1, size);
            segment.control2 = rounded(segment.control2, size);
            segment.to = rounded(segment.to, size);
        }
    }
    return paths;
}

Style rounded(Style style) {
    Stroke& stroke = style.stroke;
    stroke.width = rounded_factor(stroke.width);
    stroke.dash_offset = rounded_factor(stroke.dash_offset);
    for (double& dash : stroke.dashes) dash = rounded_factor(dash);
    return style;
}

Element moved(const Element& element, const Similarity& map, double size) {
    Element result;
    result.id = element.id;
    if (element.verbatim.empty()) {
        result.paths = rounded(transformed(element.paths, map), size);
        result.style = rounded(transformed(element.style, map));
        return result;
    }
    const std::string transform = svg_transform_text(to_affine(map));
    result.verbatim =
        transform.empty() ? element.verbatim : "<g transform=\"" + transform + "\">" + element.verbatim + "</g>";
    result.verbatim_box = corners_moved(element.verbatim_box, map);
    return result;
}

/// What lies apart and looks alike can be painted as one outline.
bool joins(const Element& group, const Element& element) {
    return group.verbatim.empty() && element.verbatim.empty() && !overlap(painted_box(group), painted_box(element)) &&
           style_text(group.style) == style_text(element.style);
}

std::vector<Element> joined(const std::vector<Element>& elements) {
    std::vector<Element> groups;
    for (const Element& element : elements) {
        if (!groups.empty() && joins(groups.back(), element)) {
            Element& group = groups.back();
            group.paths.insert(group.paths.end(), element.paths.begin(), element.paths.end());
            group.id.clear();
        } else {
            groups.push_back(element);
        }
    }
    return groups;
}

/// The number of this style in the grammar, which has it afterwards.
int numbered(Grammar& grammar, const Style& style) {
    const std::string text = style_text(style);
    int largest = 0;
    for (const NumberedStyle& known : grammar.styles) {
        if (style_text(known.style) == text) return known.number;
        largest = std::max(largest, known.number);
    }
    grammar.styles.push_back({.number = largest + 1, .style = style});
    return largest + 1;
}

Terminal terminal_of(Grammar& grammar, Element element, const std::string& symbol) {
    Terminal terminal{.symbol = symbol};
    terminal.id = element.id;
    terminal.paths = std::move(element.paths);
    terminal.verbatim = std::move(element.verbatim);
    terminal.verbatim_box = element.verbatim_box;
    if (terminal.verbatim.empty()) terminal.style = numbered(grammar, element.style);
    return terminal;
}

}  // namespace

std::string part_name(const std::string& symbol, std::size_t number) {
    return symbol + (is_digit(symbol.back()) ? "_" : "") + std::to_string(number);
}

Grammar with_drawing(Grammar grammar, const std::vector<Element>& elements, const Similarity& map,
                     const std::string& symbol) {
    Box box;
    for (const Element& element : elements) box = including(box, painted_box(element));
    const double size = scale_of(map) * diagonal(box);
    std::vector<Element> parts;
    for (const Element& element : elements) parts.push_back(moved(element, map, size));
    parts = joined(parts);

    if (parts.size() == 1) {
        grammar.terminals.push_back(terminal_of(grammar, std::move(parts.front()), symbol));
        return grammar;
    }
    Production production{.symbol = symbol};
    for (Element& part : parts) {
        const std::string name = part_name(symbol, production.successor.size() + 1);
        production.successor.push_back({name, {}, {}});
        Terminal terminal = terminal_of(grammar, std::move(part), name);
        grammar.terminals.push_back(std::move(terminal));
    }
    grammar.productions.push_back(std::move(production));
    return grammar;
}

}  // namespace rinceau
