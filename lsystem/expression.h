#pragma once
// Arithmetic over a production's parameters and the grammar's constants. One expression language for .lsys and .fgsg.

#include <string>
#include <string_view>
#include <vector>

#include "scene/input_error.h"

namespace rinceau {

/// Operators by rising precedence: || ; && ; == != < <= > >= ; + - ; * / % ; unary - ! ; ^ (power, right to left); functions
/// sin cos tan asin acos atan atan2 (degrees), sqrt exp log abs floor ceil round sign min max pow if hypot log10 trunc clamp, random
/// uniform(a, b) and normal(mean, deviation), constants pi and e.
/// A value: a tree in postfix order.
struct Expression {
    enum class Op : unsigned char {
        number, name, negate, logical_not, add, subtract, multiply, divide, modulo, power,
        less, less_equal, greater, greater_equal, equal, not_equal, logical_and, logical_or, call
    };
    struct Node {
        Op op = Op::number;
        double number = 0;   ///< Op::number
        std::string name;    ///< Op::name, Op::call
        int arguments = 0;   ///< Op::call
        friend bool operator==(const Node&, const Node&) = default;
    };
    std::vector<Node> postfix;
    friend bool operator==(const Expression&, const Expression&) = default;
};

Expression number_expression(double value);
Expression name_expression(std::string name);

/// What may stand in an expression.
struct ExpressionForm {
    /// Shape grammars: names with dots (F1.vector1.x) and names with a text (count("leaf")), which are Op::name nodes spelt
    /// without blanks, and the functions rand(), rand(a, b) and noise(x), noise(x, y), noise(x, y, z).
    bool queries = false;
    bool operand = false;  ///< only one operand with its sign: 12, -u, (a+b), f(x); no operators outside parentheses
};

/// Throws InputError at `place` (column advanced to the fault) with what was expected.
Expression parse_expression(std::string_view text, const SourcePlace& place = {}, const ExpressionForm& form = {});

/// Reads as much of the text's beginning as makes an expression; `length` is how much that is. Throws in the same way.
Expression parse_expression_before(std::string_view text, const SourcePlace& place, const ExpressionForm& form,
                                   std::size_t& length);

/// Shortest text that parses to the same expression; numbers in shortest round-trip form.
std::string to_text(const Expression& expression);

}  // namespace rinceau
