#include "growth/surface/shape_queries.h"

#include <algorithm>

#include "lsystem/similar_name.h"

namespace rinceau {

namespace {

using Quantity = FieldQuantity;
using About = ShapeQuery::About;

constexpr std::string_view components = "xyz";

std::vector<std::string> names_of(const std::vector<ShapeSource>& sources) {
    std::vector<std::string> names;
    for (const ShapeSource& source : sources) names.push_back(source.name);
    return names;
}

int index_of(const std::vector<ShapeSource>& sources, std::string_view name) {
    const auto found = std::ranges::find(sources, name, &ShapeSource::name);
    return found == sources.end() ? -1 : static_cast<int>(found - sources.begin());
}

struct QueryReader {
    const std::string& name;
    const ShapeGrammar& grammar;
    const SourcePlace& place;

    [[noreturn]] void fail(const std::string& expected, const std::string& advice = {}) const {
        throw InputError(place, "expected " + expected + ", found '" + name + "'" + advice);
    }

    ShapeQuery read() const {
        if (name == "depth") return {.about = About::depth};
        const std::size_t quote = name.find('"');
        if (quote != std::string::npos) return about_shape(name.substr(0, quote - 1), quote);
        const std::size_t dot = name.find('.');
        const std::string front = name.substr(0, dot);
        const std::string rest = name.substr(dot + 1);
        const int field = index_of(grammar.fields, front);
        if (field >= 0) return about_field(field, rest);
        if (front == "S") return {.about = About::size, .component = component(rest)};
        if (front == "P") return {.about = About::position, .component = component(rest)};
        if (front == "N") return {.about = About::normal, .component = component(rest)};
        const std::vector<std::string> fields = names_of(grammar.fields);
        fail("a field of this grammar, S, P or N before the '.'", instead_of(front, fields));
    }

    ShapeQuery about_shape(const std::string& word, std::size_t quote) const {
        const std::string shape = name.substr(quote + 1, name.size() - quote - 3);
        if (word != "count" && word != "near") fail("count(\"shape\") or near(\"shape\")");
        const int index = index_of(grammar.shapes, shape);
        if (index < 0) fail("a shape of this grammar", instead_of(shape, names_of(grammar.shapes)));
        return {.about = word == "count" ? About::count : About::near, .shape = index};
    }

    ShapeQuery about_field(int field, const std::string& rest) const {
        const std::size_t dot = rest.find('.');
        const std::string word = rest.substr(0, dot);
        const auto info = std::ranges::find(field_quantities(), word, &FieldQuantityInfo::word);
        if (info == field_quantities().end()) {
            std::vector<std::string> words;
            for (const FieldQuantityInfo& known : field_quantities()) words.emplace_back(known.word);
            fail("something to ask of a field", instead_of(word, words));
        }
        ShapeQuery query{.about = About::field, .quantity = info->quantity, .field = field};
        if (info->vector) {
            if (dot == std::string::npos) fail("one component: " + name + ".x, " + name + ".y or " + name + ".z");
            query.component = component(rest.substr(dot + 1));
        } else if (dot != std::string::npos) {
            fail("a number, which has no parts, without the last '.'");
        }
        return query;
    }

    int component(const std::string& word) const {
        const std::size_t found = word.size() == 1 ? components.find(word) : std::string::npos;
        if (found == std::string::npos) fail("x, y or z behind the '.'");
        return static_cast<int>(found);
    }
};

}  // namespace

const std::vector<FieldQuantityInfo>& field_quantities() {
    static const std::vector<FieldQuantityInfo> quantities{
        {"Xangle1", Quantity::angle1, false},
        {"Xangle2", Quantity::angle2, false},
        {"length1", Quantity::length1, false},
        {"length2", Quantity::length2, false},
        {"vector1", Quantity::vector1, true},
        {"vector2", Quantity::vector2, true},
        {"direction1", Quantity::direction1, true},
        {"direction2", Quantity::direction2, true},
        {"maxcurv", Quantity::maxcurv, false},
        {"mincurv", Quantity::mincurv, false},
        {"mean", Quantity::mean, false},
        {"gauss", Quantity::gauss, false},
        {"div", Quantity::divergence, false},
        {"curl", Quantity::curl, false},
        {"curvature", Quantity::curvature, false},
        {"gradient", Quantity::gradient, true},
        {"index", Quantity::index, false},
        {"dist", Quantity::distance, false},
        {"red", Quantity::red, false},
        {"green", Quantity::green, false},
        {"blue", Quantity::blue, false},
        {"brightness", Quantity::brightness, false},
        {"value", Quantity::value, false},
    };
    return quantities;
}

bool looks_like_query(std::string_view name) {
    return name == "depth" || name.find_first_of(".\"") != std::string_view::npos;
}

ShapeQuery parse_shape_query(const std::string& name, const ShapeGrammar& grammar, const SourcePlace& place) {
    return QueryReader{name, grammar, place}.read();
}

}  // namespace rinceau
