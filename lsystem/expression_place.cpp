#include "lsystem/expression_place.h"

#include "geometry/index.h"

namespace rinceau {

namespace {

/// One text for a grammar that may be changed and one that may not.
template <class SomeGrammar>
auto& find_string(SomeGrammar& grammar, const StringPlace& place) {
    switch (place.in) {
        case StringPlace::In::production:
            return grammar.productions.at(at(place.index)).successor;
        case StringPlace::In::exception:
            return grammar.exceptions.at(at(place.index)).successor;
        default:
            return grammar.axiom;
    }
}

template <class SomeGrammar>
auto& find_expression(SomeGrammar& grammar, const ExpressionPlace& place) {
    switch (place.in) {
        case ExpressionPlace::In::constant:
            return grammar.constants.at(at(place.index)).value;
        case ExpressionPlace::In::condition:
            return grammar.productions.at(at(place.index)).condition.value();
        case ExpressionPlace::In::weight:
            return grammar.productions.at(at(place.index)).weight.value();
        default:
            return find_string(grammar, place.string).at(at(place.position)).arguments.at(at(place.argument));
    }
}

}  // namespace

const std::vector<ModuleTemplate>& string_at(const Grammar& grammar, const StringPlace& place) {
    return find_string(grammar, place);
}
std::vector<ModuleTemplate>& string_at(Grammar& grammar, const StringPlace& place) { return find_string(grammar, place); }

std::vector<StringPlace> strings_of(const Grammar& grammar) {
    std::vector<StringPlace> places{{StringPlace::In::axiom, 0}};
    for (std::size_t i = 0; i < grammar.productions.size(); ++i)
        places.push_back({StringPlace::In::production, static_cast<int>(i)});
    for (std::size_t i = 0; i < grammar.exceptions.size(); ++i)
        places.push_back({StringPlace::In::exception, static_cast<int>(i)});
    return places;
}

const Expression& expression_at(const Grammar& grammar, const ExpressionPlace& place) {
    return find_expression(grammar, place);
}
Expression& expression_at(Grammar& grammar, const ExpressionPlace& place) { return find_expression(grammar, place); }

Expression part_at(const Grammar& grammar, const ExpressionPlace& place) {
    const Expression& whole = expression_at(grammar, place);
    return {{whole.postfix.begin() + place.first, whole.postfix.begin() + place.last}};
}

Grammar with_part(Grammar grammar, const ExpressionPlace& place, const Expression& part) {
    auto& nodes = expression_at(grammar, place).postfix;
    const auto gap = nodes.erase(nodes.begin() + place.first, nodes.begin() + place.last);
    nodes.insert(gap, part.postfix.begin(), part.postfix.end());
    return grammar;
}

bool same_expression(const ExpressionPlace& a, const ExpressionPlace& b) {
    ExpressionPlace of_a = a;
    ExpressionPlace of_b = b;
    of_a.first = of_a.last = of_b.first = of_b.last = 0;
    return of_a == of_b;
}

}  // namespace rinceau
