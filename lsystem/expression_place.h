#pragma once
// Where an expression, or a part of one, stands in a grammar, as a value: it outlives the grammar it was found in. Internal
// to the folder.

#include <vector>

#include "lsystem/grammar.h"

namespace rinceau {

/// The strings of modules of a grammar.
struct StringPlace {
    enum class In : unsigned char { axiom, production, exception };
    In in = In::axiom;
    int index = 0;  ///< of the production or exception
    friend constexpr bool operator==(const StringPlace&, const StringPlace&) = default;
};

/// The nodes [first, last) of the postfix form of an expression.
struct ExpressionPlace {
    enum class In : unsigned char { constant, module, condition, weight };
    In in = In::constant;
    int index = 0;       ///< of the constant or production
    StringPlace string;  ///< In::module
    int position = 0;    ///< In::module: of the module in its string
    int argument = 0;    ///< In::module
    int first = 0;
    int last = 0;
    friend constexpr bool operator==(const ExpressionPlace&, const ExpressionPlace&) = default;
};

const std::vector<ModuleTemplate>& string_at(const Grammar& grammar, const StringPlace& place);
std::vector<ModuleTemplate>& string_at(Grammar& grammar, const StringPlace& place);

/// Every string: the axiom, the productions' successors, the exceptions' successors.
std::vector<StringPlace> strings_of(const Grammar& grammar);

/// The whole expression that the place is in.
const Expression& expression_at(const Grammar& grammar, const ExpressionPlace& place);
Expression& expression_at(Grammar& grammar, const ExpressionPlace& place);

/// The part itself, which is an expression of its own.
Expression part_at(const Grammar& grammar, const ExpressionPlace& place);

/// The same grammar with another expression in that place.
Grammar with_part(Grammar grammar, const ExpressionPlace& place, const Expression& part);

/// Do two places have the expression in common that they are in?
bool same_expression(const ExpressionPlace& a, const ExpressionPlace& b);

}  // namespace rinceau
