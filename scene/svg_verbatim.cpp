#include "scene/svg_verbatim.h"

#include "scene/svg_fragment.h"
#include "scene/svg_number.h"
#include "scene/svg_write.h"

namespace rinceau {
namespace {

// Kept parts may repeat definitions; together they may hold this share of the bytes allowed for the drawing.
constexpr std::size_t share_of_bytes = 4;

void count_bytes(SvgReader& reader, std::size_t bytes, const SvgNode& node) {
    reader.verbatim_bytes += bytes;
    if (reader.verbatim_bytes > reader.options.max_bytes / share_of_bytes)
        throw LimitError(place_of(reader, node), "the parts that are kept as they are exceed " +
                                                     std::to_string(reader.options.max_bytes / share_of_bytes) +
                                                     " bytes; raise the byte limit or simplify the drawing");
}

std::string matrix_text(const Affine& m) {
    std::string text = "matrix(";
    for (const double value : {m.a, m.b, m.c, m.d, m.e}) text += svg_number(value) + " ";
    return text + svg_number(m.f) + ")";
}

/// Elements that draw through something else only, or are sized by it; in their place stands a group.
bool is_bare_container(const SvgContext& context) {
    const SvgNode& node = *context.node;
    if (node.name == "marker" || node.name == "symbol" || node.parent == nullptr) return true;
    return node.name == "svg" && context.parent != nullptr && context.parent->node != nullptr && context.parent->node->name == "use";
}

/// Percentages refer to the viewport, which in the fragment must be the one of the original place.
std::string in_viewport(const std::string& text, const UnitContext& units, const UnitContext& page) {
    const bool same = units.width == page.page_width && units.height == page.page_height;
    if (same || text.find('%') == std::string::npos) return text;
    return "<svg width=\"" + svg_number(units.width) + "\" height=\"" + svg_number(units.height) + "\" overflow=\"visible\">" + text +
           "</svg>";
}

std::string fragment(SvgReader& reader, const SvgContext& context) {
    SvgFragmentWriter writer(reader, next_id_prefix(reader));
    const SvgNode& node = *context.node;
    const bool as_group = is_bare_container(context);
    const SvgContext& place = as_group || context.parent == nullptr ? context : *context.parent;
    const SvgContext& around = context.parent == nullptr ? context : *context.parent;
    const std::string element = writer.element_text(node, as_group);
    const std::string style = writer.declarations_text(inherited_declarations(around));
    const std::string definitions = writer.definitions_text(node);
    std::string text = "<g";
    if (place.map != Affine{}) text += " transform=\"" + matrix_text(place.map) + "\"";
    if (!style.empty()) text += " style=\"" + style + "\"";
    text += ">" + in_viewport(element, place.units, reader.root_units) + "</g>";
    return definitions.empty() ? text : "<defs>" + definitions + "</defs>" + text;
}

}  // namespace

std::string next_id_prefix(SvgReader& reader) { return "k" + std::to_string(++reader.kept_parts) + "-"; }

void keep_verbatim(SvgReader& reader, const SvgContext& context, const Box& box, std::string_view warning) {
    Element element;
    element.verbatim = fragment(reader, context);
    element.verbatim_box = box;
    if (const std::string_view* id = find_attribute(*context.node, "id")) element.id = *id;
    count_bytes(reader, element.verbatim.size(), *context.node);
    reader.warnings.add(warning, *context.node);
    add_element(reader, std::move(element), *context.node);
}

Element wrapped(SvgReader& reader, const Element& element, const std::string& attributes, const std::string& definitions,
                const Box& box, const SvgNode& owner) {
    Element group;
    group.id = element.id;
    group.verbatim_box = box;
    const SvgElementText inner = svg_element_text(element, next_id_prefix(reader));
    const std::string all_definitions = definitions + inner.definitions;
    if (!all_definitions.empty()) group.verbatim = "<defs>" + all_definitions + "</defs>";
    group.verbatim += "<g " + attributes + ">" + inner.body + "</g>";
    count_bytes(reader, group.verbatim.size(), owner);
    return group;
}

}  // namespace rinceau
