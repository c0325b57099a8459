#include "exports/python_syntax.h"

#include <algorithm>
#include <array>

#include "lsystem/number_text.h"

namespace rinceau {

namespace {

using Op = Expression::Op;

constexpr std::array taken_names{
    std::string_view{"False"},     std::string_view{"None"},     std::string_view{"True"},
    std::string_view{"and"},       std::string_view{"as"},       std::string_view{"assert"},
    std::string_view{"async"},     std::string_view{"await"},    std::string_view{"break"},
    std::string_view{"class"},     std::string_view{"continue"}, std::string_view{"def"},
    std::string_view{"del"},       std::string_view{"elif"},     std::string_view{"else"},
    std::string_view{"except"},    std::string_view{"exec"},     std::string_view{"finally"},
    std::string_view{"for"},       std::string_view{"from"},     std::string_view{"global"},
    std::string_view{"if"},        std::string_view{"import"},   std::string_view{"in"},
    std::string_view{"is"},        std::string_view{"lambda"},   std::string_view{"math"},
    std::string_view{"max"},       std::string_view{"min"},      std::string_view{"module"},
    std::string_view{"nonlocal"},  std::string_view{"not"},      std::string_view{"nproduce"},
    std::string_view{"nsproduce"}, std::string_view{"or"},       std::string_view{"pass"},
    std::string_view{"print"},     std::string_view{"produce"},  std::string_view{"raise"},
    std::string_view{"return"},    std::string_view{"sproduce"}, std::string_view{"try"},
    std::string_view{"while"},     std::string_view{"with"},     std::string_view{"yield"},
    std::string_view{"abs"},       std::string_view{"float"},    std::string_view{"BezierCurve"},
    std::string_view{"Polyline"},  std::string_view{"Group"},
};

/// Functions that Python has not: the definition of rinceau_<name>.
struct Definition {
    std::string_view name;
    std::string_view text;
};

constexpr std::array definitions{
    Definition{
        "sin",
        "def rinceau_sin(x):\n"
        "    x = math.remainder(x, 360)\n"
        "    return 0.0 if abs(x) in (0, 180) else math.copysign(1, x) if abs(x) == 90 else math.sin(math.radians(x))\n"},
    Definition{"cos",
               "def rinceau_cos(x):\n"
               "    x = abs(math.remainder(x, 360))\n"
               "    return 0.0 if x == 90 else -1.0 if x == 180 else math.cos(math.radians(x))\n"},
    Definition{"tan", "def rinceau_tan(x): return rinceau_sin(x) / rinceau_cos(x)\n"},
    Definition{"asin", "def rinceau_asin(x): return math.degrees(math.asin(x))\n"},
    Definition{"acos", "def rinceau_acos(x): return math.degrees(math.acos(x))\n"},
    Definition{"atan", "def rinceau_atan(x): return math.degrees(math.atan(x))\n"},
    Definition{"atan2", "def rinceau_atan2(y, x): return math.degrees(math.atan2(y, x))\n"},
    Definition{"round", "def rinceau_round(x): return math.copysign(math.floor(abs(x) + 0.5), x)\n"},
    Definition{"sign", "def rinceau_sign(x): return (x > 0) - (x < 0)\n"},
    Definition{"clamp", "def rinceau_clamp(x, low, high): return min(max(x, low), high)\n"},
};

/// Functions that Python has under another name.
struct Renamed {
    std::string_view name;
    std::string_view python;
};
constexpr std::array renamed{
    Renamed{"sqrt", "math.sqrt"},   Renamed{"exp", "math.exp"},     Renamed{"log", "math.log"},
    Renamed{"abs", "abs"},          Renamed{"floor", "math.floor"}, Renamed{"ceil", "math.ceil"},
    Renamed{"min", "min"},          Renamed{"max", "max"},          Renamed{"pow", "math.pow"},
    Renamed{"hypot", "math.hypot"}, Renamed{"log10", "math.log10"}, Renamed{"trunc", "math.trunc"},
};

std::string joined(const std::vector<std::string>& arguments) {
    std::string text;
    for (const std::string& argument : arguments) text += (text.empty() ? "" : ", ") + argument;
    return text;
}

std::optional<std::string> python_operation(Op op, const std::vector<std::string>& operands) {
    switch (op) {
        case Op::power:
            return "float(" + operands[0] + ")**" + operands[1];
        case Op::modulo:
            return operands[0] + " % " + operands[1];
        case Op::equal:
            return operands[0] + " == " + operands[1];
        case Op::not_equal:
            return operands[0] + " != " + operands[1];
        case Op::logical_and:
            return "(" + operands[0] + " != 0) and (" + operands[1] + " != 0)";
        case Op::logical_or:
            return "(" + operands[0] + " != 0) or (" + operands[1] + " != 0)";
        case Op::logical_not:
            return operands[0] + " == 0";
        default:
            return common_operation(op, operands);
    }
}

std::optional<std::string> python_call(std::string_view function, const std::vector<std::string>& arguments,
                                       std::set<std::string>& used) {
    if (function == "if") return '(' + arguments[1] + ") if (" + arguments[0] + ") else (" + arguments[2] + ')';
    if ((function == "min" || function == "max") && arguments.size() == 1) return arguments[0];
    const auto* const found = std::ranges::find(renamed, function, &Renamed::name);
    if (found != renamed.end()) {
        if (found->python.starts_with("math.")) used.insert("math");
        return std::string(found->python) + '(' + joined(arguments) + ')';
    }
    if (std::ranges::find(definitions, function, &Definition::name) == definitions.end()) return std::nullopt;
    used.insert(std::string(function));
    return "rinceau_" + std::string(function) + '(' + joined(arguments) + ')';
}

}  // namespace

bool is_python_name_taken(std::string_view name) { return std::ranges::find(taken_names, name) != taken_names.end(); }

ExpressionSyntax python_syntax(std::set<std::string>& used) {
    return {.number = number_text,
            .operation = python_operation,
            .call = [&used](std::string_view function, const std::vector<std::string>& arguments) {
                return python_call(function, arguments, used);
            }};
}

std::string python_prelude(const std::set<std::string>& used) {
    if (used.empty()) return {};
    std::string text = "import math\n";
    for (const Definition& definition : definitions) {
        const bool needed = used.contains(std::string(definition.name)) ||
                            (used.contains("tan") && (definition.name == "sin" || definition.name == "cos"));
        if (needed) text += definition.text;
    }
    return text;
}

}  // namespace rinceau
