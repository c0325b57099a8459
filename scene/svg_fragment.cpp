#include "scene/svg_fragment.h"

#include <algorithm>

#include "scene/svg_number.h"

namespace rinceau {
namespace {

void append_escaped(std::string& text, std::string_view value) {
    for (const char c : value) {
        switch (c) {
            case '&':
                text += "&amp;";
                break;
            case '<':
                text += "&lt;";
                break;
            case '>':
                text += "&gt;";
                break;
            case '"':
                text += "&quot;";
                break;
            // Line ends in attributes would be read as spaces.
            case '\n':
                text += "&#10;";
                break;
            default:
                text += c;
        }
    }
}

/// Scripts and animations: a kept part stands still. Titles and the like draw nothing.
bool is_left_out(const SvgNode& node) {
    static constexpr std::string_view names[] = {"script",        "style",        "title", "desc",
                                                 "metadata",      "animate",      "set",   "animateTransform",
                                                 "animateMotion", "animateColor", "mpath"};
    return is_svg(node) && std::ranges::find(names, node.name) != std::end(names);
}

bool is_inside(const SvgNode& node, const SvgNode& ancestor) {
    for (const SvgNode* up = &node; up != nullptr; up = up->parent)
        if (up == &ancestor) return true;
    return false;
}

/// An id that was renamed by an earlier reading gets its own name back: "k12-name" is "name".
std::string_view without_prefix(std::string_view id) {
    std::size_t end = 1;
    while (end < id.size() && id[end] >= '0' && id[end] <= '9') ++end;
    return id.starts_with('k') && end > 1 && end < id.size() && id[end] == '-' ? id.substr(end + 1) : id;
}

/// Lengths in em and per cent of the font size hold where they are specified, not where they are inherited.
std::string settled_value(const std::string& property, const std::string& value, const SvgContext& context) {
    if (property == "font-size") return svg_number(context.style.font_size) + "px";
    const bool spacing = property == "letter-spacing" || property == "word-spacing";
    const bool length = property == "stroke-width" || property == "stroke-dashoffset";
    if (!spacing && !length) return value;
    const auto px = parse_length(value, context.units, LengthAxis::diagonal);
    return px ? svg_number(*px) : value;
}

/// Contexts from the outermost to `context`.
std::vector<const SvgContext*> way_to(const SvgContext& context) {
    std::vector<const SvgContext*> way;
    for (const SvgContext* at = &context; at != nullptr; at = at->parent) way.push_back(at);
    std::ranges::reverse(way);
    return way;
}

/// A container in the place of which a group is written: that has its place already, and only effects of its own.
bool belongs_on_group(std::string_view property) {
    return is_presentation_attribute(property) && !property.starts_with("transform");
}

}  // namespace

SpecifiedStyle inherited_declarations(const SvgContext& context) {
    std::map<std::string, std::string> merged;
    for (const SvgContext* at : way_to(context))
        for (const auto& [property, value] : at->specified) {
            if (!is_inherited_property(property) || value == "inherit" || value == "unset") continue;
            // A shorthand sets its parts anew; it comes before them in the list.
            if (property == "font" || property == "marker")
                std::erase_if(merged,
                              [part_of = property + "-"](const auto& part) { return part.first.starts_with(part_of); });
            merged[property] = settled_value(property, value, *at);
        }
    return {merged.begin(), merged.end()};
}

std::string SvgFragmentWriter::renamed(std::string_view id) const { return prefix_ + std::string(without_prefix(id)); }

void SvgFragmentWriter::refer_to(std::string_view id, bool by_use) {
    const SvgNode* node = reader_.tree.find(id);
    if (node == nullptr) return;
    for (Target& target : targets_)
        if (target.node == node) return;
    targets_.push_back({node, by_use});
}

std::string SvgFragmentWriter::renamed_references(std::string_view value) {
    std::string text;
    std::size_t done = 0;
    for (std::size_t at = value.find("url("); at != std::string_view::npos; at = value.find("url(", done)) {
        std::size_t begin = at + 4;
        while (begin < value.size() && (is_svg_space(value[begin]) || value[begin] == '"' || value[begin] == '\'')) ++begin;
        const std::size_t end = std::min(value.find_first_of("\"')", begin), value.size());
        text += value.substr(done, begin - done);
        const std::string_view target = trimmed(value.substr(begin, end - begin));
        if (target.starts_with('#')) {
            refer_to(target.substr(1), false);
            text += "#" + renamed(target.substr(1));
        } else {
            text += target;
        }
        done = end;
    }
    text += value.substr(done);
    return text;
}

std::string SvgFragmentWriter::declarations_text(const SpecifiedStyle& style) {
    std::string text;
    for (const auto& [property, value] : style) {
        if (!text.empty()) text += ';';
        text += property + ":";
        append_escaped(text, renamed_references(value));
    }
    return text;
}

void SvgFragmentWriter::write_attributes(const SvgNode& node, const SpecifiedStyle& inherited, bool as_group,
                                         std::string& text) {
    std::string_view own_style;
    for (const SvgAttribute& attribute : node.attributes) {
        const std::string_view name = attribute.name;
        const bool drawing = is_svg(node) && attribute.space == SvgNamespace::none;
        if (drawing && name == "style") own_style = attribute.value;
        if (drawing && (name == "style" || name == "class" || name.starts_with("on"))) continue;
        if (as_group && !belongs_on_group(name)) continue;
        std::string value;
        std::string_view prefix;
        switch (attribute.space) {
            case SvgNamespace::none:
                break;
            case SvgNamespace::xlink:
                prefix = "xlink:";
                break;
            case SvgNamespace::xml:
                prefix = "xml:";
                break;
            default:
                continue;
        }
        if (name == "id" && attribute.space == SvgNamespace::none) {
            value = renamed(attribute.value);
        } else if (name == "href" && trimmed(attribute.value).starts_with('#') && node.name != "a") {
            const std::string_view id = trimmed(attribute.value).substr(1);
            refer_to(id, node.name == "use");
            value = "#" + renamed(id);
        } else {
            value = renamed_references(attribute.value);
        }
        text += ' ';
        text += prefix;
        text += name;
        text += "=\"";
        append_escaped(text, value);
        text += '"';
    }
    if (!is_svg(node)) return;
    SpecifiedStyle style = specified_style(reader_.sheet, reader_.css, &node, {}, own_style, is_understood);
    if (as_group) std::erase_if(style, [](const auto& declaration) { return declaration.first.starts_with("transform"); });
    for (const auto& declaration : inherited)
        if (find_value(style, declaration.first) == nullptr && find_attribute(node, declaration.first) == nullptr)
            style.push_back(declaration);
    std::ranges::sort(style);
    if (!style.empty()) text += " style=\"" + declarations_text(style) + "\"";
}

void SvgFragmentWriter::write_children(const SvgNode& node, bool inside_foreign, std::string& text) {
    for (const SvgNode* child = node.first_child; child != nullptr; child = child->next) {
        if (is_text(*child))
            append_escaped(text, child->text);
        else
            write_element(*child, {}, false, inside_foreign, text);
    }
}

void SvgFragmentWriter::write_element(const SvgNode& node, const SpecifiedStyle& inherited, bool as_group,
                                      bool inside_foreign, std::string& text) {
    // Elements of editors draw nothing; those inside a foreignObject are its content.
    if (is_left_out(node) || (!is_svg(node) && !inside_foreign) || (!is_svg(node) && node.name == "script")) return;
    const std::string name(as_group ? std::string_view("g") : node.name);
    text += "<" + name;
    const bool namespace_changes = node.parent == nullptr || is_svg(*node.parent) != is_svg(node);
    if (!is_svg(node) && namespace_changes) text += " xmlns=\"" + std::string(node.space_name) + "\"";
    if (is_svg(node) && inside_foreign && namespace_changes) text += " xmlns=\"http://www.w3.org/2000/svg\"";
    write_attributes(node, inherited, as_group, text);
    const std::size_t before = text.size();
    text += '>';
    write_children(node, inside_foreign || (is_svg(node) && node.name == "foreignObject"), text);
    if (text.size() == before + 1) {
        text.back() = '/';
        text += '>';
    } else {
        text += "</" + name + ">";
    }
}

std::string SvgFragmentWriter::element_text(const SvgNode& node, bool as_group) {
    std::string text;
    write_element(node, {}, as_group, false, text);
    return text;
}

std::string SvgFragmentWriter::definitions_text(const SvgNode& root) {
    // Writing one definition may find more of them.
    std::vector<std::pair<const SvgNode*, std::string>> written;
    for (std::size_t i = 0; i < targets_.size(); ++i) {
        const Target target = targets_[i];
        // What is there already; and what would lead back to the root.
        if (is_inside(*target.node, root) || is_inside(root, *target.node)) continue;
        SpecifiedStyle inherited;
        if (!target.by_use) inherited = inherited_declarations(*ancestor_contexts(reader_, *target.node).back());
        std::string text;
        write_element(*target.node, inherited, false, false, text);
        written.emplace_back(target.node, std::move(text));
    }
    std::string definitions;
    for (const auto& [node, text] : written) {
        const SvgNode* own = node;
        const bool within_another = std::ranges::any_of(
            written, [&](const auto& other) { return other.first != own && is_inside(*own, *other.first); });
        if (!within_another) definitions += text;
    }
    return definitions;
}

}  // namespace rinceau
