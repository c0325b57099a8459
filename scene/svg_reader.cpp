#include "scene/svg_reader.h"

#include "scene/svg_number.h"
#include "scene/svg_transform.h"

namespace rinceau {

std::vector<Warning> SvgWarningLog::summary(const std::string& file_name) const {
    struct Kind {
        std::size_t count = 0;
        int line = 0;
    };
    std::map<std::string_view, std::size_t> numbers;
    std::vector<std::pair<std::string_view, Kind>> kinds;
    for (const Entry& entry : entries_) {
        const auto [found, added] = numbers.emplace(entry.kind, kinds.size());
        if (added) kinds.push_back({entry.kind, {0, entry.line}});
        ++kinds[found->second].second.count;
    }
    std::vector<Warning> warnings;
    for (const auto& [kind, seen] : kinds) {
        std::string message(kind);
        if (const std::size_t at = message.find("{}"); at != std::string::npos) message.replace(at, 2, std::to_string(seen.count));
        warnings.push_back({{file_name, seen.line, 0}, std::move(message)});
    }
    return warnings;
}

SourcePlace place_of(const SvgReader& reader, const SvgNode& node) {
    const SvgNode* known = &node;
    // Very deep elements have no line of their own.
    while (known->line == 0 && known->parent != nullptr) known = known->parent;
    return {reader.options.file_name, known->line, 0};
}

const SvgNode* find_reference(const SvgReader& reader, std::string_view reference) {
    const std::string_view trimmed_reference = trimmed(reference);
    if (!trimmed_reference.starts_with('#')) return nullptr;
    return reader.tree.find(trimmed_reference.substr(1));
}

SpecifiedStyle specified_style(const SvgReader& reader, const SvgNode& node) {
    std::vector<std::pair<std::string_view, std::string_view>> presentation;
    std::string_view style_attribute;
    for (const SvgAttribute& attribute : node.attributes) {
        if (attribute.space != SvgNamespace::none) continue;
        if (attribute.name == "style") style_attribute = attribute.value;
        else if (is_presentation_attribute(attribute.name)) presentation.emplace_back(attribute.name, attribute.value);
    }
    return specified_style(reader.sheet, reader.css, &node, presentation, style_attribute);
}

namespace {

/// The element's own transform, in its parent's space. Faults are reported and count as no transform.
Affine own_transform(SvgReader& reader, const SvgContext& context) {
    if (context.style.transform.empty()) return {};
    const Box reference{{0, 0}, {context.units.width, context.units.height}};
    ParsedTransform transform = parse_transform_attribute(context.style.transform);
    if (!transform.map) transform = parse_css_transform(context.style.transform, context.units, reference);
    if (!transform.map) {
        reader.warnings.add("{} transforms are faulty and left out", *context.node);
        return {};
    }
    if (context.style.transform_origin.empty()) return *transform.map;
    const auto origin = parse_transform_origin(context.style.transform_origin, context.units, reference);
    return origin ? about(*transform.map, *origin) : *transform.map;
}

}  // namespace

SvgContext enter(SvgReader& reader, const SvgContext& parent, const SvgNode& node) {
    if (parent.depth >= reader.options.max_depth)
        throw LimitError(place_of(reader, node), "elements and references are nested more than " +
                                                     std::to_string(reader.options.max_depth) +
                                                     " deep; flatten the drawing or raise the depth limit");
    SvgContext context;
    context.parent = &parent;
    context.node = &node;
    context.specified = specified_style(reader, node);
    context.units = parent.units;
    context.style = computed_style(context.specified, parent.style, parent.units);
    context.units.font_size = context.style.font_size;
    context.map = parent.map * own_transform(reader, context);
    context.depth = parent.depth + 1;
    context.context_style = parent.context_style;
    return context;
}

std::vector<std::unique_ptr<SvgContext>> ancestor_contexts(SvgReader& reader, const SvgNode& node) {
    std::vector<const SvgNode*> ancestors;
    for (const SvgNode* up = node.parent; up != nullptr; up = up->parent) ancestors.push_back(up);
    std::vector<std::unique_ptr<SvgContext>> contexts;
    auto outside = std::make_unique<SvgContext>();
    outside->units = reader.root_units;
    outside->depth = 0;
    contexts.push_back(std::move(outside));
    for (auto ancestor = ancestors.rbegin(); ancestor != ancestors.rend(); ++ancestor) {
        contexts.push_back(std::make_unique<SvgContext>(enter(reader, *contexts.back(), **ancestor)));
        contexts.back()->map = {};
    }
    return contexts;
}

void take_back(SvgReader& reader, std::size_t first, SvgWarningLog::Mark mark) {
    reader.scene.elements.resize(first);
    reader.warnings.take_back(mark);
}

void add_element(SvgReader& reader, Element element, const SvgNode& node) {
    if (++reader.drawn > reader.options.max_elements)
        throw LimitError(place_of(reader, node), "the drawing has more than " + std::to_string(reader.options.max_elements) +
                                                     " elements once every use is expanded; raise the limit or simplify the drawing");
    reader.scene.elements.push_back(std::move(element));
}

}  // namespace rinceau
