#include "exports/cpfg_syntax.h"

#include <algorithm>
#include <array>

#include "lsystem/number_text.h"

namespace rinceau {

namespace {

using Op = Expression::Op;
using Texts = std::vector<std::string>;

constexpr std::array taken_names{
    std::string_view{"if"},
    std::string_view{"while"},
    std::string_view{"do"},
    std::string_view{"else"},
    std::string_view{"array"},
    std::string_view{"external"},
    std::string_view{"tan"},
    std::string_view{"sin"},
    std::string_view{"atan2"},
    std::string_view{"cos"},
    std::string_view{"atan"},
    std::string_view{"asin"},
    std::string_view{"acos"},
    std::string_view{"ran"},
    std::string_view{"nran"},
    std::string_view{"bran"},
    std::string_view{"biran"},
    std::string_view{"srand"},
    std::string_view{"exp"},
    std::string_view{"log"},
    std::string_view{"floor"},
    std::string_view{"ceil"},
    std::string_view{"sign"},
    std::string_view{"sqrt"},
    std::string_view{"trunc"},
    std::string_view{"fabs"},
    std::string_view{"inblob"},
    std::string_view{"stop"},
    std::string_view{"printf"},
    std::string_view{"fprintf"},
    std::string_view{"fopen"},
    std::string_view{"fclose"},
    std::string_view{"fflush"},
    std::string_view{"fscanf"},
    std::string_view{"func"},
    std::string_view{"play"},
    std::string_view{"curveX"},
    std::string_view{"curveY"},
    std::string_view{"curveZ"},
    std::string_view{"curveGAL"},
    std::string_view{"SetDerivationLength"},
    std::string_view{"GetDerivationLength"},
    std::string_view{"Display"},
    std::string_view{"Q"},
    std::string_view{"Z"},
    std::string_view{"K"},
};

std::string in_parentheses(const std::string& text) { return '(' + text + ')'; }

std::optional<std::string> cpfg_operation(Op op, const Texts& operands) {
    switch (op) {
        case Op::power:
            return operands[0] + '^' + operands[1];
        case Op::modulo:  // the sign is that of the divisor
            return operands[0] + '-' + operands[1] + "*floor(" + operands[0] + '/' + operands[1] + ')';
        case Op::equal:
            return operands[0] + " == " + operands[1];
        case Op::not_equal:
            return operands[0] + " != " + operands[1];
        case Op::logical_and:
            return operands[0] + " && " + operands[1];
        case Op::logical_or:
            return operands[0] + " || " + operands[1];
        case Op::logical_not:
            return '!' + operands[0];
        default:
            return common_operation(op, operands);
    }
}

std::string choice(const std::string& condition, const std::string& then, const std::string& otherwise) {
    return in_parentheses(condition) + '?' + in_parentheses(then) + ':' + in_parentheses(otherwise);
}

/// The least or the greatest of the arguments.
std::string extreme(const Texts& arguments, const std::string& sign) {
    std::string text = arguments.front();
    for (std::size_t i = 1; i < arguments.size(); ++i)
        text = choice(in_parentheses(text) + sign + in_parentheses(arguments[i]), text, arguments[i]);
    return text;
}

std::optional<std::string> trigonometric(std::string_view function, const Texts& arguments, std::set<std::string>& used) {
    const std::string name(function);
    if (name == "sin" || name == "cos" || name == "tan") {
        used.insert("k_degree");
        return name + "((" + arguments[0] + ")*k_degree)";
    }
    if (name == "asin" || name == "acos" || name == "atan" || name == "atan2") {
        used.insert("k_radian");
        return name + '(' + arguments[0] + (arguments.size() > 1 ? ',' + arguments[1] : "") + ")*k_radian";
    }
    return std::nullopt;
}

std::optional<std::string> cpfg_call(std::string_view function, const Texts& a, std::set<std::string>& used) {
    if (function == "sqrt" || function == "exp" || function == "log" || function == "floor" || function == "ceil" ||
        function == "trunc")
        return std::string(function) + '(' + a[0] + ')';
    if (function == "abs") return "fabs(" + a[0] + ')';
    if (function == "log10") return "log(" + a[0] + ")/log(10)";
    if (function == "pow") return in_parentheses(a[0]) + '^' + in_parentheses(a[1]);
    if (function == "hypot") return "sqrt((" + a[0] + ")^2+(" + a[1] + ")^2)";
    if (function == "min") return extreme(a, "<");
    if (function == "max") return extreme(a, ">");
    if (function == "clamp") return extreme({extreme({a[0], a[1]}, ">"), a[2]}, "<");
    if (function == "if") return choice(a[0], a[1], a[2]);
    if (function == "sign") return choice(in_parentheses(a[0]) + ">0", "1", choice(in_parentheses(a[0]) + "<0", "-1", "0"));
    if (function == "round")
        return choice(in_parentheses(a[0]) + "<0", "-floor(0.5-(" + a[0] + "))", "floor((" + a[0] + ")+0.5)");
    return trigonometric(function, a, used);
}

}  // namespace

std::string cpfg_number(double value) {
    std::string text = number_text(value);
    const std::size_t exponent = text.find('e');
    if (exponent != std::string::npos && text.find('.') == std::string::npos) text.insert(exponent, ".0");
    return text;
}

bool is_cpfg_name_taken(std::string_view name) { return std::ranges::find(taken_names, name) != taken_names.end(); }

ExpressionSyntax cpfg_syntax(std::set<std::string>& used) {
    return {
        .number = cpfg_number,
        .operation = cpfg_operation,
        .call = [&used](std::string_view function, const Texts& arguments) { return cpfg_call(function, arguments, used); }};
}

std::string cpfg_prelude(const std::set<std::string>& used) {
    std::string text;
    if (!used.empty()) text = "/* Angles are degrees, whichever unit the functions of this cpfg take and give. */\n";
    if (used.contains("k_degree")) text += "#define k_degree (sin(90)>0.999?1:0.017453292519943295)\n";
    if (used.contains("k_radian")) text += "#define k_radian (asin(1)>2?1:57.29577951308232)\n";
    return text;
}

}  // namespace rinceau
