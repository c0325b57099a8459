#include "scene/svg_adopt.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/svg_style.h"

namespace rinceau {
namespace {

using tinyxml2::XMLElement;
using tinyxml2::XMLNode;

/// Initial values (SVG 1.1, appendix N) of what can be inherited and shows in outlines and text.
constexpr std::pair<std::string_view, std::string_view> initial_values[] = {
    {"clip-rule", "nonzero"},      {"color", "#000000"},          {"fill", "#000000"},          {"fill-opacity", "1"},
    {"fill-rule", "nonzero"},      {"font-style", "normal"},      {"font-variant", "normal"},   {"font-weight", "normal"},
    {"letter-spacing", "normal"},  {"marker-end", "none"},        {"marker-mid", "none"},       {"marker-start", "none"},
    {"paint-order", "normal"},     {"shape-rendering", "auto"},   {"stroke", "none"},           {"stroke-dasharray", "none"},
    {"stroke-dashoffset", "0"},    {"stroke-linecap", "butt"},    {"stroke-linejoin", "miter"}, {"stroke-miterlimit", "4"},
    {"stroke-opacity", "1"},       {"stroke-width", "1"},         {"text-anchor", "start"},     {"visibility", "visible"},
    {"word-spacing", "normal"},    {"writing-mode", "lr-tb"}};

/// Of what is an element's own.
constexpr std::pair<std::string_view, std::string_view> own_values[] = {
    {"clip-path", "none"},  {"display", "inline"},         {"filter", "none"},    {"isolation", "auto"},
    {"mask", "none"},       {"mix-blend-mode", "normal"},  {"opacity", "1"},      {"overflow", "visible"},
    {"stop-color", "#000"}, {"stop-opacity", "1"},         {"transform", "none"}, {"vector-effect", "none"}};

void for_each_element(XMLElement* element, const std::function<void(XMLElement&)>& act) {
    for (; element != nullptr; element = element->NextSiblingElement()) {
        act(*element);
        for_each_element(element->FirstChildElement(), act);
    }
}

/// "url(#a)" in any place, with the names that `name_of` gives.
std::string with_references(const std::string& value, const std::map<std::string, std::string>& names) {
    std::string text;
    std::size_t done = 0;
    for (std::size_t at = value.find("url("); at != std::string::npos; at = value.find("url(", done)) {
        const std::size_t begin = value.find('#', at);
        const std::size_t end = begin == std::string::npos ? begin : value.find_first_of("\"')", begin);
        if (end == std::string::npos) break;
        const auto renamed = names.find(value.substr(begin + 1, end - begin - 1));
        text += value.substr(done, begin + 1 - done);
        text += renamed == names.end() ? value.substr(begin + 1, end - begin - 1) : renamed->second;
        done = end;
    }
    return text + value.substr(done);
}

void rename_in(XMLElement& element, const std::map<std::string, std::string>& names) {
    std::vector<std::pair<std::string, std::string>> changed;
    for (const auto* attribute = element.FirstAttribute(); attribute != nullptr; attribute = attribute->Next()) {
        const std::string name = attribute->Name(), value = attribute->Value();
        const bool reference = (name == "href" || name == "xlink:href") && value.starts_with('#');
        std::string text = with_references(value, names);
        if (name == "id" || reference) {
            const auto renamed = names.find(reference ? value.substr(1) : value);
            if (renamed != names.end()) text = (reference ? "#" : "") + renamed->second;
        }
        if (text != value) changed.emplace_back(name, text);
    }
    for (const auto& [name, value] : changed) element.SetAttribute(name.c_str(), value.c_str());
}

/// Whether a list of declarations has this property.
bool declares(const std::string& declarations, const std::string& property) {
    for (std::size_t at = 0; at < declarations.size();) {
        const std::size_t end = std::min(declarations.find(';', at), declarations.size());
        const std::size_t begin = std::min(declarations.find_first_not_of(" \t\n", at), end);
        const std::size_t colon = declarations.find_first_of(": \t\n", begin);
        if (colon < end && declarations.compare(begin, colon - begin, property) == 0) return true;
        at = end + 1;
    }
    return false;
}

void append(std::string& declarations, std::string_view property, std::string_view value) {
    if (!declarations.empty() && declarations.back() != ';') declarations += ';';
    ((declarations += property) += ':') += value;
}

void shield(XMLElement& element, const std::set<std::string>& properties) {
    const char* given = element.Attribute("style");
    std::string style = given == nullptr ? "" : given;
    std::vector<std::string> moved;
    for (const auto* attribute = element.FirstAttribute(); attribute != nullptr; attribute = attribute->Next()) {
        const std::string name = attribute->Name();
        // a transform is no property to every program
        if (!is_presentation_attribute(name) || name.starts_with("transform") || name == "gradientTransform") continue;
        moved.push_back(name);
        if (!declares(style, name)) append(style, name, attribute->Value());
    }
    for (const std::string& name : moved) element.DeleteAttribute(name.c_str());
    for (const std::string& property : properties) {
        if (declares(style, property)) continue;
        if (is_inherited_property(property)) append(style, property, "inherit");
        const auto* own = std::ranges::find(own_values, property, &std::pair<std::string_view, std::string_view>::first);
        if (own != std::end(own_values) && property != "transform") append(style, property, own->second);
    }
    if (!style.empty()) element.SetAttribute("style", style.c_str());
}

}  // namespace

void rename_ids(tinyxml2::XMLDocument& svg, const std::function<bool(const std::string&)>& is_taken) {
    std::set<std::string> own;
    const auto collect = [&](XMLElement& element) {
        if (const char* id = element.Attribute("id")) own.insert(id);
    };
    for_each_element(svg.RootElement()->FirstChildElement(), collect);
    std::map<std::string, std::string> names;
    for (const std::string& id : own) {
        if (!is_taken(id)) continue;
        std::string name;
        for (int number = 2; name.empty() || is_taken(name) || own.contains(name); ++number)
            name = id + "-" + std::to_string(number);
        names.emplace(id, name);
    }
    for_each_element(svg.RootElement()->FirstChildElement(), [&](XMLElement& element) { rename_in(element, names); });
}

void use_xlink(tinyxml2::XMLDocument& svg) {
    for_each_element(svg.RootElement()->FirstChildElement(), [](XMLElement& element) {
        if (std::string_view(element.Name()) != "use") return;
        const char* href = element.Attribute("href");
        if (href == nullptr) return;
        const std::string reference = href;
        element.DeleteAttribute("href");
        element.SetAttribute("xlink:href", reference.c_str());
    });
}

std::set<std::string> properties_of(const StyleSheet& sheet) {
    std::set<std::string> properties;
    for (const auto& block : sheet.blocks)
        for (const CssDeclaration& declaration : block) properties.emplace(declaration.property);
    return properties;
}

void shield_styles(tinyxml2::XMLDocument& svg, const std::set<std::string>& properties) {
    if (properties.empty()) return;
    for_each_element(svg.RootElement()->FirstChildElement(), [&](XMLElement& element) { shield(element, properties); });
}

std::string initial_declarations(const std::set<std::string>& properties) {
    std::string text;
    for (const auto& [property, value] : initial_values)
        if (properties.contains(std::string(property))) append(text, property, value);
    for (const auto& [property, value] : own_values)
        if (property != "transform" && properties.contains(std::string(property))) append(text, property, value);
    return text;
}

std::string content_text(const tinyxml2::XMLDocument& svg) {
    constexpr bool compact = true;
    tinyxml2::XMLPrinter printer(nullptr, compact);
    for (const XMLNode* child = svg.RootElement()->FirstChild(); child != nullptr; child = child->NextSibling())
        child->Accept(&printer);
    return printer.CStr();
}

}  // namespace rinceau
