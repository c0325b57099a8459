#include "growth/surface/field_json.h"

#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "geometry/angle.h"
#include "geometry/index.h"
#include "growth/surface/field_filled.h"
#include "growth/surface/field_of_numbers.h"
#include "growth/surface/field_smooth.h"
#include "growth/surface/vertex_axes.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

using Json = nlohmann::json;

/// A value of a document and where it stands.
struct Part {
    const Json& json;
    std::string label, path;

    [[noreturn]] void fail(const std::string& expected) const {
        throw InputError({label}, (path.empty() ? "" : path + ": ") + "expected " + expected + ", found " + found());
    }
    std::string found() const {
        if (json.is_array()) return "a list of " + std::to_string(json.size());
        if (json.is_object()) return "an object";
        constexpr std::size_t longest = 40;
        const std::string text = json.dump(-1, ' ', true, Json::error_handler_t::replace);
        return text.size() <= longest ? text : text.substr(0, longest) + "..";
    }
    bool has(const char* key) const { return json.contains(key); }
    Part operator[](const char* key) const { return {json.at(key), label, path.empty() ? key : path + '.' + key}; }
    Part operator[](std::size_t i) const { return {json.at(i), label, path + '[' + std::to_string(i) + ']'}; }

    double number() const {
        if (!json.is_number() || !std::isfinite(json.get<double>())) fail("a number");
        return json.get<double>();
    }
    int whole(int lowest, int highest) const {
        if (!json.is_number_integer() || json.get<double>() < lowest || json.get<double>() > highest)
            fail("a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest));
        return json.get<int>();
    }
    std::string text() const {
        if (!json.is_string()) fail("a text");
        return json.get<std::string>();
    }
    /// A list of `count` numbers.
    template <std::size_t count>
    std::array<double, count> numbers() const {
        if (!json.is_array() || json.size() != count) fail("a list of " + std::to_string(count) + " numbers");
        std::array<double, count> values;
        for (std::size_t i = 0; i < count; ++i) {
            if (!json[i].is_number()) (*this)[i].fail("a number");
            values[i] = json[i].get<double>();
        }
        return values;
    }
    /// One value for every vertex.
    void expect_list_for(const SurfaceMesh& surface) const {
        if (!json.is_array()) fail("a list");
        if (json.size() == at(surface.vertices())) return;
        throw InputError({label}, path + ": the list has " + std::to_string(json.size()) + " values but the surface has " +
                                      std::to_string(surface.vertices()) + " vertices; expected one for each vertex");
    }
    void expect_keys(std::initializer_list<const char*> known) const {
        if (!json.is_object()) fail("an object {..}");
        for (const auto& [key, value] : json.items()) {
            std::string names;
            bool found = false;
            for (const char* name : known) {
                found = found || key == name;
                names.append(names.empty() ? "" : ", ").append(name);
            }
            if (!found)
                throw InputError(
                    {label}, (path.empty() ? "" : path + ": ") + "unknown key \"" + key + "\"; expected one of " + names);
        }
    }
};

/// Line and column of a byte, counted from 1.
SourcePlace place_of(std::string_view text, std::size_t byte, const std::string& label) {
    SourcePlace place{label, 1, 1};
    for (const char c : text.substr(0, std::min(byte, text.size()))) {
        ++place.column;
        if (c == '\n') place = {label, place.line + 1, 1};
    }
    return place;
}

Json parsed(std::string_view text, const std::string& label) {
    constexpr int deepest = 8;
    const auto watch = [&](int depth, Json::parse_event_t, const Json&) {
        if (depth > deepest) throw InputError({label}, "expected a field, found JSON that is nested deeper than any field");
        return true;
    };
    try {
        return Json::parse(text, watch);
    } catch (const Json::parse_error& error) {
        throw InputError(place_of(text, error.byte > 0 ? error.byte - 1 : 0, label), "expected JSON text of a field");
    } catch (const Json::exception&) {  // a number beyond all bounds
        throw InputError({label}, "a number of the JSON text is too large");
    }
}

int read_n(const Part& part) {
    const int n = part.json.is_number_integer() ? part.whole(-1000, 1000) : 0;
    if (n != 1 && n != 2 && n != 4) part.fail("1 (vectors), 2 (tensors and line fields) or 4 (crosses)");
    return n;
}

std::vector<Complex> read_vectors(const Part& list, const SurfaceMesh& surface, int n) {
    list.expect_list_for(surface);
    std::vector<Complex> values;
    for (int v = 0; v < surface.vertices(); ++v) {
        const auto [x, y, z] = list[at(v)].numbers<3>();
        const Complex tangent = from_space_to_vertex(surface, vertex_axis(surface, v), v, {x, y, z});
        const double strength = abs(tangent);
        values.push_back(strength > 0 ? strength * power(tangent / strength, n) : Complex{});
    }
    return values;
}

std::vector<Complex> read_values(const Part& list, const SurfaceMesh& surface) {
    list.expect_list_for(surface);
    std::vector<Complex> values;
    for (std::size_t v = 0; v < list.json.size(); ++v) {
        const auto [re, im] = list[v].numbers<2>();
        values.push_back({re, im});
    }
    return values;
}

std::vector<double> read_numbers(const Part& list, const SurfaceMesh& surface) {
    list.expect_list_for(surface);
    std::vector<double> numbers;
    for (std::size_t v = 0; v < list.json.size(); ++v) numbers.push_back(list[v].number());
    return numbers;
}

int read_vertex(const Part& element, const SurfaceMesh& surface) {
    if (element.has("vertex") == element.has("at"))
        element.fail("either \"vertex\" or \"at\", which says where the element is");
    if (element.has("vertex")) return element["vertex"].whole(0, surface.vertices() - 1);
    const auto [x, y, z] = element["at"].numbers<3>();
    return nearest_vertex(surface, {x, y, z});
}

double read_direction(const Part& element, const SurfaceMesh& surface, int vertex) {
    if (element.has("direction") && element.has("angle")) element.fail("\"direction\" or \"angle\", not both");
    if (element.has("direction")) {
        const auto [x, y, z] = element["direction"].numbers<3>();
        return direction_at_vertex(surface, vertex, {x, y, z});
    }
    const double angle = element.has("angle") ? element["angle"].number() : 0;
    return reference_direction(surface, vertex) + radians(angle);
}

FieldElement read_element(const Part& part, const SurfaceMesh& surface) {
    part.expect_keys({"type", "vertex", "at", "direction", "angle", "turn", "weight", "decay", "fall"});
    if (!part.has("type")) part.fail("a \"type\"");
    FieldElement element;
    const auto kind = field_element_kind(part["type"].text());
    if (!kind) {
        std::string names;
        for (const int n : {1, 2, 4})
            for (const FieldElementKind one : field_element_kinds(n))
                if (names.find(name_of(one)) == std::string::npos)
                    names.append(names.empty() ? "" : ", ").append(name_of(one));
        part["type"].fail("one of " + names);
    }
    element.kind = *kind;
    element.vertex = read_vertex(part, surface);
    element.direction = read_direction(part, surface, element.vertex);
    if (part.has("turn")) element.turn = radians(part["turn"].number());
    if (part.has("weight")) element.weight = part["weight"].number();
    if (part.has("decay")) element.decay = part["decay"].number();
    if (part.has("fall")) {
        const std::string fall = part["fall"].text();
        if (fall != "exp" && fall != "gauss") part["fall"].fail("\"exp\" or \"gauss\"");
        element.gauss = fall == "gauss";
    }
    return element;
}

/// "key": [ one value a line ].
template <class Row>
void add_list(std::string& text, const char* key, std::size_t count, Row row) {
    text.append(",\n \"").append(key).append("\": [\n");
    for (std::size_t i = 0; i < count; ++i) text.append("  ").append(row(i).dump()).append(i + 1 < count ? ",\n" : "\n");
    text.append(" ]");
}

}  // namespace

SurfaceField read_field_json(std::string_view text, const SurfaceMesh& surface, const std::string& label) {
    const Json json = parsed(text, label);
    const Part document{json, label, {}};
    document.expect_keys({"n", "vectors", "z", "frame", "isotropic", "scalar"});
    SurfaceField field{.n = 2, .label = label};
    if (document.has("n")) field.n = read_n(document["n"]);
    if (document.has("isotropic")) field.isotropic = read_numbers(document["isotropic"], surface);
    if (document.has("scalar")) field.scalar = read_numbers(document["scalar"], surface);
    if (document.has("vectors") && document.has("z")) document.fail("\"vectors\" or \"z\", not both");
    if (document.has("vectors")) {
        field.values = read_vectors(document["vectors"], surface, field.n);
    } else if (document.has("z")) {
        if (document.has("frame") && document["frame"].text() != "edge") document["frame"].fail("\"edge\"");
        field.values = read_values(document["z"], surface);
    } else if (!field.scalar.empty()) {
        return field_of_numbers(surface, std::move(field.scalar), label);
    } else {
        document.fail("\"vectors\", \"z\" or \"scalar\", the values by vertex");
    }
    (void)filled_field(surface, field);  // says what is wrong with the values
    return field;
}

std::string field_json(const SurfaceField& field, const SurfaceMesh& surface, FieldFrame frame) {
    const SurfaceField values = of_plane(field) ? filled_field(surface, field) : field;
    std::string text = "{\"n\": " + std::to_string(values.n);
    if (frame == FieldFrame::edge) {
        text += ", \"frame\": \"edge\"";
        add_list(text, "z", values.values.size(), [&](std::size_t v) {
            return Json{values.values[v].x, values.values[v].y};
        });
    } else {
        add_list(text, "vectors", values.values.size(), [&](std::size_t v) {
            const Complex z = values.values[v];
            const int vertex = static_cast<int>(v);
            const Complex way = polar(abs(z), arg(z) / values.n);
            const SpacePoint p = from_vertex_to_space(surface, vertex_axis(surface, vertex), vertex, way);
            return Json{p.x, p.y, p.z};
        });
    }
    for (const auto& [key, numbers] : {std::pair{"isotropic", &values.isotropic}, std::pair{"scalar", &values.scalar}})
        if (!numbers->empty())
            add_list(text, key, numbers->size(), [&, list = numbers](std::size_t v) { return Json((*list)[v]); });
    return text + "}\n";
}

FieldDesign read_field_design_json(std::string_view text, const SurfaceMesh& surface, const std::string& label) {
    const Json json = parsed(text, label);
    const Part document{json, label, {}};
    FieldDesign design;
    const auto read_elements = [&](const Part& list) {
        if (!list.json.is_array()) list.fail("a list of elements");
        for (std::size_t i = 0; i < list.json.size(); ++i) design.elements.push_back(read_element(list[i], surface));
    };
    if (json.is_array()) {
        read_elements(document);
        return design;
    }
    document.expect_keys({"n", "elements", "smooth", "rounds"});
    if (!document.has("elements")) document.fail("\"elements\", a list");
    if (document.has("n")) design.n = read_n(document["n"]);
    if (document.has("smooth")) design.smooth = document["smooth"].number();
    if (document.has("rounds")) design.rounds = document["rounds"].whole(0, most_smoothing_rounds);
    read_elements(document["elements"]);
    return design;
}

}  // namespace rinceau
