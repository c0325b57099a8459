#include "scene/svg_reader.h"

#include <algorithm>

#include "scene/svg_number.h"
#include "scene/svg_transform.h"

namespace rinceau {

namespace {

constexpr std::size_t longest_quotation = 40;

/// The value on one line, and not too long.
std::string quotation(std::string_view value) {
    std::string text(trimmed(value));
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' '; };
    std::ranges::replace_if(text, is_control, ' ');
    if (text.size() <= longest_quotation) return text;
    std::size_t end = longest_quotation;
    // No character of several bytes is cut.
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
    return text.substr(0, end) + "...";
}

void replace_first(std::string& text, std::string_view mark, const std::string& by) {
    if (const std::size_t at = text.find(mark); at != std::string::npos) text.replace(at, mark.size(), by);
}

}  // namespace

void SvgWarningLog::add_value(std::string kind, std::string_view value, const SvgNode& node) {
    const auto kept = value_kinds_.insert(std::move(kind)).first;
    entries_.push_back({*kept, quotation(value), node.line, &node});
}

std::vector<Warning> SvgWarningLog::summary(const std::string& file_name) const {
    struct Kind {
        const Entry* first = nullptr;
        std::size_t count = 0;
    };
    std::map<std::string_view, std::size_t> numbers;
    std::vector<Kind> kinds;
    std::set<std::pair<std::size_t, const SvgNode*>> counted;
    for (const Entry& entry : entries_) {
        const auto [found, added] = numbers.emplace(entry.kind, kinds.size());
        if (added) kinds.push_back({&entry, 0});
        if (entry.counts_once != nullptr && !counted.emplace(found->second, entry.counts_once).second) continue;
        ++kinds[found->second].count;
    }
    std::vector<Warning> warnings;
    for (const Kind& kind : kinds) {
        std::string message(kind.first->kind);
        replace_first(message, "{}", std::to_string(kind.count));
        replace_first(message, "{value}", kind.first->value);
        warnings.push_back({{file_name, kind.first->line, 0}, std::move(message)});
    }
    return warnings;
}

SourcePlace place_of(const SvgReader& reader, const SvgNode& node) {
    const SvgNode* known = &node;
    // Very deep elements have no line of their own.
    while (known->line == 0 && known->parent != nullptr) known = known->parent;
    return {reader.options.file_name, known->line, 0};
}

void note_fault(SvgReader& reader, const SvgNode& node, std::string_view name, std::string_view value,
                std::string_view instead) {
    if (trimmed(value).empty()) return;
    std::string kind = "{} ";
    for (const std::string_view part : {node.name, std::string_view(" elements have "), name,
                                        std::string_view("=\"{value}\", which is not understood; "), instead})
        kind += part;
    reader.warnings.add_value(std::move(kind), value, node);
}

const SvgNode* find_reference(const SvgReader& reader, std::string_view reference) {
    const std::string_view trimmed_reference = trimmed(reference);
    if (!trimmed_reference.starts_with('#')) return nullptr;
    return reader.tree.find(trimmed_reference.substr(1));
}

SpecifiedStyle specified_style(SvgReader& reader, const SvgNode& node) {
    std::vector<std::pair<std::string_view, std::string_view>> presentation;
    std::string_view style_attribute;
    for (const SvgAttribute& attribute : node.attributes) {
        if (attribute.space != SvgNamespace::none) continue;
        if (attribute.name == "style")
            style_attribute = attribute.value;
        else if (is_presentation_attribute(attribute.name))
            presentation.emplace_back(attribute.name, attribute.value);
    }
    const auto accepts = [&](std::string_view property, std::string_view value) {
        const bool accepted = is_understood(property, value);
        // An older value before a newer one is a replacement by intention; a variable may hold something else.
        if (!accepted && value.find("var(") != std::string_view::npos)
            note_fault(reader, node, property, value, "the value that it replaces is taken");
        return accepted;
    };
    return specified_style(reader.sheet, reader.css, &node, presentation, style_attribute, accepts);
}

namespace {

/// The element's own transform, in its parent's space. Faults are reported and count as no transform.
Affine own_transform(SvgReader& reader, const SvgContext& context) {
    if (context.style.transform.empty()) return {};
    const Box reference{{0, 0}, {context.units.width, context.units.height}};
    ParsedTransform transform = parse_transform_attribute(context.style.transform);
    if (!transform.map) transform = parse_css_transform(context.style.transform, context.units, reference);
    if (!transform.map) {
        note_fault(reader, *context.node, "transform", context.style.transform, "it is left out");
        return {};
    }
    const std::string& origin_text = context.style.transform_origin;
    if (context.style.fill_box && (!origin_text.empty() || context.style.transform.find('%') != std::string::npos))
        reader.warnings.add(
            "{} elements are transformed within their own box (transform-box), which is not supported; the box of the "
            "viewport is taken",
            *context.node);
    if (origin_text.empty()) return *transform.map;
    const auto origin = parse_transform_origin(origin_text, context.units, reference);
    if (!origin) note_fault(reader, *context.node, "transform-origin", origin_text, "the origin is taken");
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
    for (const auto& [property, value] : context.style.faults)
        note_fault(reader, node, property, value, "the inherited value, or else the default, is taken");
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
        throw LimitError(place_of(reader, node),
                         "the drawing has more than " + std::to_string(reader.options.max_elements) +
                             " elements once every use is expanded; raise the limit or simplify the drawing");
    reader.scene.elements.push_back(std::move(element));
}

namespace {

// Places are counted for all elements of a parent when the first of them is asked for, so that each is counted once.
class CountedPlaces {
  public:
    CssPlace of(const SvgNode& node) {
        if (node.parent == nullptr) return {};
        if (counted_.insert(node.parent).second) count_elements(*node.parent);
        return places_[&node];
    }

  private:
    void count_elements(const SvgNode& parent) {
        std::unordered_map<std::string_view, int> of_name;
        const SvgNode* last = nullptr;
        for (const SvgNode* child = parent.first_child; child != nullptr; child = child->next) {
            if (is_text(*child)) continue;
            last = child;
            places_[child] = {.child = child->position, .of_type = ++of_name[child->name]};
        }
        for (const SvgNode* child = last; child != nullptr; child = child->previous_element) {
            CssPlace& place = places_[child];
            place.child_from_end = last->position - child->position + 1;
            place.of_type_from_end = of_name[child->name] - place.of_type + 1;
        }
    }

    std::unordered_set<const SvgNode*> counted_;  ///< parents
    std::unordered_map<const SvgNode*, CssPlace> places_;
};

// The language of the nearest `xml:lang`, or of `lang` beside it where there is none.
std::string_view language_of(const SvgNode* node) {
    for (; node != nullptr; node = node->parent) {
        for (const SvgAttribute& attribute : node->attributes) {
            if (attribute.name == "lang" && attribute.space == SvgNamespace::xml) return attribute.value;
        }
        if (const std::string_view* language = find_attribute(*node, "lang")) return *language;
    }
    return {};
}

CssTree css_tree() {
    const auto node = [](CssNode css) { return static_cast<const SvgNode*>(css); };
    return {.name = [node](CssNode css) { return node(css)->name; },
            .attribute = [node](CssNode css, std::string_view name) -> std::optional<std::string_view> {
                const std::string_view* value = find_attribute(*node(css), name);
                return value == nullptr ? std::nullopt : std::optional(*value);
            },
            .parent = [node](CssNode css) -> CssNode { return node(css)->parent; },
            .previous = [node](CssNode css) -> CssNode { return node(css)->previous_element; },
            .next = [node](CssNode css) -> CssNode { return node(css)->next_element; },
            .place = [node, places = std::make_shared<CountedPlaces>()](CssNode css) { return places->of(*node(css)); },
            .empty = [node](CssNode css) { return node(css)->first_child == nullptr; },
            .link = [node](CssNode css) { return node(css)->name == "a" && !href_of(*node(css)).empty(); },
            .language = [node](CssNode css) { return language_of(node(css)); }};
}

bool is_style_sheet(const SvgNode& node) {
    if (!is_svg(node) || node.name != "style") return false;
    const std::string_view* type = find_attribute(node, "type");
    return type == nullptr || type->empty() || lower_case(trimmed(*type)) == "text/css";
}

void collect_sheets(const SvgNode& node, std::vector<std::string>& sheets) {
    for (const SvgNode* child = node.first_child; child != nullptr; child = child->next) {
        if (!is_style_sheet(*child)) {
            collect_sheets(*child, sheets);
            continue;
        }
        std::string& sheet = sheets.emplace_back();
        for (const SvgNode* text = child->first_child; text != nullptr; text = text->next) sheet += text->text;
    }
}

StyleSheet style_sheet_of(const SvgTree& tree) {
    std::vector<std::string> sheets;
    collect_sheets(tree.root(), sheets);
    return parse_style_sheets(sheets);
}

}  // namespace

SvgReader reader_of(const SvgTree& tree, const SvgReadOptions& options) {
    return {.tree = tree, .options = options, .sheet = style_sheet_of(tree), .css = css_tree()};
}

}  // namespace rinceau
