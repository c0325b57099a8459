#include "lsystem/constant_values.h"

#include <algorithm>
#include <cmath>

#include "lsystem/noise_form.h"

namespace rinceau {

std::optional<double> value_of(const Expression& expression, const Scope& constants) {
    if (is_random(expression)) return std::nullopt;
    try {
        const Program program = compile_expression(expression, constants, {});
        if (!is_constant(program) || !std::isfinite(program.code.front().number)) return std::nullopt;
        return program.code.front().number;
    } catch (const InputError&) {
        return std::nullopt;  // a name that is not known here
    }
}

Scope constants_of(const Grammar& grammar) {
    Scope scope;
    for (const Constant& constant : grammar.constants)
        if (const auto value = value_of(constant.value, scope)) scope.constants.try_emplace(constant.name, *value);
    return scope;
}

bool is_plain_number(const Expression& expression) {
    return expression.postfix.size() == 1 && expression.postfix.front().op == Expression::Op::number;
}

int constant_behind(const Grammar& grammar, const Expression& expression) {
    int found = -1;
    const Expression* next = &expression;
    // constants use constants above them, so that the chain ends
    for (std::size_t below = grammar.constants.size(); below > 0;) {
        if (next->postfix.size() != 1 || next->postfix.front().op != Expression::Op::name) break;
        const std::string& name = next->postfix.front().name;
        const auto end = grammar.constants.begin() + static_cast<std::ptrdiff_t>(below);
        const auto constant =
            std::find_if(grammar.constants.begin(), end, [&](const Constant& c) { return c.name == name; });
        if (constant == end) break;
        below = static_cast<std::size_t>(constant - grammar.constants.begin());
        found = static_cast<int>(below);
        next = &constant->value;
    }
    return found;
}

}  // namespace rinceau
