#include "scene/svg_write.h"

#include <algorithm>
#include <set>
#include <utility>

#include "scene/svg_number.h"

namespace rinceau {

namespace {

std::string attribute(const std::string& name, const std::string& value) {
    return value.empty() ? std::string() : " " + name + "=\"" + value + "\"";
}

Paint mapped(const Paint& paint, const Affine& map) {
    const auto* gradient = std::get_if<std::shared_ptr<const Gradient>>(&paint);
    if (!gradient) return paint;
    Gradient image = **gradient;
    image.map = map * image.map;
    return std::make_shared<const Gradient>(std::move(image));
}

// An outline whose pen is a circle, drawn under `transform`.
SvgElementText outline_text(const std::vector<Path>& paths, const Style& style, const Affine& transform,
                            const std::string& id_prefix, int digits) {
    SvgStyleText style_text = svg_style_text(style, id_prefix);
    return {"<path" + attribute("transform", svg_transform_text(transform)) + style_text.attributes + " d=\"" +
                svg_path_data(paths, digits) + "\"/>",
            std::move(style_text.definitions)};
}

// Under transform = pen, paths and gradients take the inverse map and the stroke's pen is a circle.
SvgElementText stretched_outline_text(const Element& element, const Affine& pen, const std::string& id_prefix, int digits) {
    const Affine back = inverse(pen);
    Style style = element.style;
    style.fill = mapped(style.fill, back);
    style.stroke.paint = mapped(style.stroke.paint, back);
    return outline_text(transformed(element.paths, back), style, pen, id_prefix, digits);
}

// A prefix that neither an id nor a verbatim fragment of the scene has.
std::string free_prefix(const Scene& scene) {
    std::string prefix = "paint";
    const auto taken = [&](const Element& element) {
        return element.id.starts_with(prefix) || element.verbatim.find(prefix) != std::string::npos;
    };
    while (std::any_of(scene.elements.begin(), scene.elements.end(), taken)) prefix += '_';
    return prefix;
}

}  // namespace

std::string xml_escaped(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            default:
                escaped += c;
        }
    }
    return escaped;
}

SvgElementText svg_element_text(const Element& element, const std::string& id_prefix, int digits) {
    if (!element.verbatim.empty()) return {element.verbatim, {}};
    const Linear2& pen = element.style.stroke.pen;
    const Affine pen_map{pen.a, pen.b, pen.c, pen.d, 0, 0};
    const bool stretched = pen != Linear2{} && determinant(pen_map) != 0 && paints_stroke(element.style);
    return stretched ? stretched_outline_text(element, pen_map, id_prefix, digits)
                     : outline_text(element.paths, element.style, Affine{}, id_prefix, digits);
}

std::string svg_root_tag(const Box& viewport, bool sized) {
    std::string tag = "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\"";
    if (sized && width(viewport) > 0 && height(viewport) > 0) {
        const std::string wide = svg_number(width(viewport));
        const std::string high = svg_number(height(viewport));
        tag += attribute("width", wide) + attribute("height", high);
        tag +=
            attribute("viewBox", svg_number(viewport.low.x) + " " + svg_number(-viewport.high.y) + " " + wide + " " + high);
    }
    return tag + ">";
}

std::string write_svg(const Scene& scene) {
    const std::string prefix = free_prefix(scene);
    std::string definitions;
    std::string body;
    std::set<std::string> written_ids;
    for (std::size_t i = 0; i < scene.elements.size(); ++i) {
        const Element& element = scene.elements[i];
        SvgElementText text = svg_element_text(element, prefix + std::to_string(i));
        definitions += text.definitions;
        // Pieces of one compound path share their id; the first one keeps it.
        const bool has_id = element.verbatim.empty() && !element.id.empty() && written_ids.insert(element.id).second;
        if (has_id) text.body.insert(text.body.find("<path") + 5, attribute("id", xml_escaped(element.id)));
        body += text.body + "\n";
    }
    if (!definitions.empty()) definitions = "<defs>" + definitions + "</defs>\n";
    return svg_root_tag(scene.viewport, scene.sized) + "\n" + definitions + body + "</svg>\n";
}

}  // namespace rinceau
