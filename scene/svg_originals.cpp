#include "scene/svg_originals.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/affine.h"
#include "scene/svg_number.h"
#include "scene/svg_transform.h"

namespace rinceau {
namespace {

using tinyxml2::XMLElement;

bool draws_in_place(std::string_view name) {
    static constexpr std::string_view names[] = {"g",    "path",     "rect",    "circle", "ellipse",
                                                 "line", "polyline", "polygon", "use",    "text", "image"};
    return std::ranges::find(names, name) != std::end(names);
}

std::string text_of(const XMLElement& element, const char* attribute) {
    const char* value = element.Attribute(attribute);
    return value == nullptr ? "" : value;
}

Affine transform_of(const XMLElement& element) {
    return parse_transform_attribute(text_of(element, "transform")).map.value_or(Affine{});
}

/// The transform of a use and the place that it moves its target to.
Affine map_of_use(const XMLElement& use) {
    return transform_of(use) * Affine{1, 0, 0, 1, use.DoubleAttribute("x"), use.DoubleAttribute("y")};
}

/// Products of transforms carry rounding errors in their last digits, which would be written out.
double rounded(double value) {
    constexpr int digits = 12;
    if (value == 0) return 0;
    const double grid = std::pow(10.0, digits - 1 - std::floor(std::log10(std::abs(value))));
    return std::isfinite(grid) ? std::round(value * grid) / grid : value;
}

/// Numbers of the linear part below a rounding error of it are none.
std::string matrix_text(Affine m) {
    constexpr double nothing = 1e-14;
    const double size = std::max({std::abs(m.a), std::abs(m.b), std::abs(m.c), std::abs(m.d)});
    for (double* number : {&m.a, &m.b, &m.c, &m.d}) *number = std::abs(*number) < nothing * size ? 0 : rounded(*number);
    m.e = rounded(m.e);
    m.f = rounded(m.f);
    if (m == Affine{}) return {};
    const auto list = [](std::initializer_list<double> numbers) {
        std::string text;
        for (const double number : numbers) text += (text.empty() ? "" : " ") + svg_number(number);
        return text;
    };
    if (m.a == 1 && m.b == 0 && m.c == 0 && m.d == 1) return "translate(" + list({m.e, m.f}) + ")";
    return "matrix(" + list({m.a, m.b, m.c, m.d, m.e, m.f}) + ")";
}

void set_transform(XMLElement& element, const Affine& map) {
    const std::string text = matrix_text(map);
    if (text.empty())
        element.DeleteAttribute("transform");
    else
        element.SetAttribute("transform", text.c_str());
}

class OriginalPlacer {
  public:
    explicit OriginalPlacer(tinyxml2::XMLDocument& document) : document_(document) {
        for (XMLElement* defs = document.RootElement()->FirstChildElement("defs"); defs != nullptr;
             defs = defs->NextSiblingElement("defs"))
            for (XMLElement* child = defs->FirstChildElement(); child != nullptr; child = child->NextSiblingElement())
                if (draws_in_place(child->Name())) definitions_.emplace(text_of(*child, "id"), child);
    }

    void place() {
        walk(*document_.RootElement());
        for (const auto& [id, map] : placed_) document_.DeleteNode(definitions_.at(id));
    }

  private:
    void walk(XMLElement& parent) {
        for (XMLElement* child = parent.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
            const std::string_view name = child->Name();
            if (name == "defs") continue;
            if (name == "use") child = &clone_or_original(*child);
            walk(*child);
        }
    }

    XMLElement& clone_or_original(XMLElement& use) {
        std::string reference = text_of(use, "href");
        if (reference.empty()) reference = text_of(use, "xlink:href");
        const std::string id = reference.starts_with('#') ? reference.substr(1) : "";
        const auto definition = definitions_.find(id);
        if (definition == definitions_.end()) return use;
        const Affine map = map_of_use(use);
        if (const auto placed = placed_.find(id); placed != placed_.end()) {
            use.DeleteAttribute("x");
            use.DeleteAttribute("y");
            set_transform(use, map * inverse(placed->second));
            return use;
        }
        if (determinant(map) == 0) return use;
        placed_.emplace(id, map);
        return put_original(use, *definition->second, map);
    }

    /// In the place of `use`. What the use hands down to its target, a group around the original does.
    XMLElement& put_original(XMLElement& use, const XMLElement& definition, const Affine& map) {
        XMLElement* original = definition.DeepClone(&document_)->ToElement();
        set_transform(*original, map * transform_of(definition));
        XMLElement* outer = original;
        std::vector<std::pair<std::string, std::string>> handed_down;
        for (const auto* attribute = use.FirstAttribute(); attribute != nullptr; attribute = attribute->Next()) {
            static constexpr std::string_view own[] = {"href", "xlink:href", "transform", "x", "y", "width", "height"};
            if (std::ranges::find(own, std::string_view(attribute->Name())) == std::end(own))
                handed_down.emplace_back(attribute->Name(), attribute->Value());
        }
        if (!handed_down.empty()) {
            outer = document_.NewElement("g");
            for (const auto& [name, value] : handed_down) outer->SetAttribute(name.c_str(), value.c_str());
            outer->InsertEndChild(original);
        }
        tinyxml2::XMLNode* parent = use.Parent();
        parent->InsertAfterChild(&use, outer);
        parent->DeleteChild(&use);
        return *outer;
    }

    tinyxml2::XMLDocument& document_;
    std::map<std::string, XMLElement*> definitions_;
    std::map<std::string, Affine> placed_;  ///< the use that became the original
};

}  // namespace

void make_originals_real(tinyxml2::XMLDocument& svg) { OriginalPlacer(svg).place(); }

}  // namespace rinceau
