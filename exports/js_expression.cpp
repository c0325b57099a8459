#include "exports/js_expression.h"

#include <numbers>
#include <vector>

#include "exports/number.h"

namespace rinceau {

namespace {

using Op = Expression::Op;

std::string name_text(const std::string& name, const std::map<std::string, std::string>& names) {
    const auto found = names.find(name);
    if (found != names.end()) return found->second;
    if (name == "pi") return number_of(std::numbers::pi);
    return name == "e" ? number_of(std::numbers::e) : name;
}

std::string truth(const std::string& condition) { return '(' + condition + " ? 1 : 0)"; }

std::string binary_text(Op op, const std::string& a, const std::string& b) {
    switch (op) {
        case Op::add:
            return '(' + a + " + " + b + ')';
        case Op::subtract:
            return '(' + a + " - " + b + ')';
        case Op::multiply:
            return '(' + a + " * " + b + ')';
        case Op::divide:
            return '(' + a + " / " + b + ')';
        case Op::modulo:
            return "math.mod(" + a + ", " + b + ')';
        case Op::power:
            return "math.pow(" + a + ", " + b + ')';
        case Op::less:
            return truth(a + " < " + b);
        case Op::less_equal:
            return truth(a + " <= " + b);
        case Op::greater:
            return truth(a + " > " + b);
        case Op::greater_equal:
            return truth(a + " >= " + b);
        case Op::equal:
            return truth(a + " === " + b);
        case Op::not_equal:
            return truth(a + " !== " + b);
        case Op::logical_and:
            return truth(a + " && " + b);
        default:
            return truth(a + " || " + b);
    }
}

}  // namespace

std::string js_expression(const Expression& expression, const std::map<std::string, std::string>& names) {
    std::vector<std::string> stack;
    const auto pop = [&] {
        std::string top = std::move(stack.back());
        stack.pop_back();
        return top;
    };
    for (const Expression::Node& node : expression.postfix) {
        if (node.op == Op::number) {
            const std::string text = number_of(node.number);
            stack.push_back(text.starts_with('-') ? '(' + text + ')' : text);
        } else if (node.op == Op::name) {
            stack.push_back(name_text(node.name, names));
        } else if (node.op == Op::negate) {
            stack.push_back("(-" + pop() + ')');
        } else if (node.op == Op::logical_not) {
            stack.push_back(truth("!" + pop()));
        } else if (node.op == Op::call) {
            std::string list;
            for (int i = 0; i < node.arguments; ++i) list = pop() + (list.empty() ? "" : ", ") + list;
            stack.push_back("math." + (node.name == "if" ? std::string("choose") : node.name) + '(' + list + ')');
        } else {
            const std::string right = pop();
            const std::string left = pop();
            stack.push_back(binary_text(node.op, left, right));
        }
    }
    const std::string& text = stack.back();
    // one pair of parentheses around the whole says nothing
    if (!text.starts_with('(') || !text.ends_with(')')) return text;
    int open = 0;
    for (std::size_t i = 0; i + 1 < text.size(); ++i) {
        open += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
        if (open == 0) return text;
    }
    return text.substr(1, text.size() - 2);
}

std::string js_functions() {
    return R"(// The functions of the grammar's expressions; angles in degrees.
const inRadians = Math.PI / 180;
const math = {
  sin: a => Math.sin(a * inRadians), cos: a => Math.cos(a * inRadians), tan: a => Math.tan(a * inRadians),
  asin: a => Math.asin(a) / inRadians, acos: a => Math.acos(a) / inRadians, atan: a => Math.atan(a) / inRadians,
  atan2: (a, b) => Math.atan2(a, b) / inRadians,
  sqrt: Math.sqrt, exp: Math.exp, log: Math.log, log10: Math.log10, abs: Math.abs, sign: Math.sign, hypot: Math.hypot,
  floor: Math.floor, ceil: Math.ceil, trunc: Math.trunc, pow: Math.pow, min: Math.min, max: Math.max,
  round: a => Math.sign(a) * Math.floor(Math.abs(a) + 0.5),
  mod: (a, b) => a - b * Math.floor(a / b),
  clamp: (a, low, high) => Math.min(Math.max(a, low), high),
  choose: (condition, yes, no) => (condition ? yes : no),
};
)";
}

}  // namespace rinceau
