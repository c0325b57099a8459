#include "lsystem/expression.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "lsystem/expression_functions.h"
#include "lsystem/number_text.h"
#include "lsystem/similar_name.h"

namespace rinceau {

Expression number_expression(double value) { return {{{Expression::Op::number, value, {}, 0}}}; }

Expression name_expression(std::string name) { return {{{Expression::Op::name, 0, std::move(name), 0}}}; }

namespace {

using Op = Expression::Op;

struct BinaryOperator {
    std::string_view symbol;
    Op op;
    int precedence;
};

constexpr int unary_precedence = 6;
constexpr int power_precedence = 7;
constexpr int atom_precedence = 8;

// Longer symbols before their prefixes.
constexpr std::array binary_operators{
    BinaryOperator{"||", Op::logical_or, 1}, BinaryOperator{"&&", Op::logical_and, 2},
    BinaryOperator{"==", Op::equal, 3},      BinaryOperator{"!=", Op::not_equal, 3},
    BinaryOperator{"<=", Op::less_equal, 3}, BinaryOperator{">=", Op::greater_equal, 3},
    BinaryOperator{"<", Op::less, 3},        BinaryOperator{">", Op::greater, 3},
    BinaryOperator{"+", Op::add, 4},         BinaryOperator{"-", Op::subtract, 4},
    BinaryOperator{"*", Op::multiply, 5},    BinaryOperator{"/", Op::divide, 5},
    BinaryOperator{"%", Op::modulo, 5},      BinaryOperator{"^", Op::power, power_precedence},
};

/// Recursive descent by precedence; writes the nodes in postfix order as it goes.
class Parser {
  public:
    Parser(std::string_view text, const SourcePlace& place, const ExpressionForm& form)
        : text_(text), place_(place), form_(form) {}

    Expression parse() {
        std::size_t length = 0;
        Expression expression = parse_before(length);
        skip_blanks();
        if (at_ < text_.size()) fail("expected an operator, found " + found());
        return expression;
    }

    Expression parse_before(std::size_t& length) {
        if (form_.operand) {
            unary();
        } else {
            binary(1);
        }
        length = at_;
        return std::move(expression_);
    }

  private:
    static constexpr int max_nesting = 200;            // keeps the call stack small whatever the text
    static constexpr std::size_t max_nodes = 100'000;  // keeps memory small: a node is many times as long as its text

    std::string_view text_;
    const SourcePlace& place_;
    ExpressionForm form_;
    std::size_t at_ = 0;
    int nesting_ = 0;
    Expression expression_;

    [[noreturn]] void fail_at(std::size_t offset, const std::string& message) const {
        SourcePlace place = place_;
        for (const char c : text_.substr(0, offset)) {
            if (c == '\n') {
                ++place.line;
                place.column = 1;
            } else {
                ++place.column;
            }
        }
        throw InputError(place, message);
    }
    [[noreturn]] void fail(const std::string& message) const { fail_at(at_, message); }

    std::string found() const {
        if (at_ >= text_.size()) return "the end";
        std::size_t end = at_ + 1;
        while (continues_name(text_[at_]) && end < text_.size() && continues_name(text_[end])) ++end;
        return '\'' + std::string(text_.substr(at_, end - at_)) + '\'';
    }

    void skip_blanks() {
        while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    }
    bool take(std::string_view symbol) {
        skip_blanks();
        if (!text_.substr(at_).starts_with(symbol)) return false;
        at_ += symbol.size();
        return true;
    }
    void emit(Op op) { expression_.postfix.push_back({op, 0, {}, 0}); }

    const BinaryOperator* peek_operator() {
        skip_blanks();
        const auto* found = std::ranges::find_if(binary_operators, [&](const BinaryOperator& candidate) {
            return text_.substr(at_).starts_with(candidate.symbol);
        });
        return found == binary_operators.end() ? nullptr : found;
    }

    void binary(int lowest) {
        if (++nesting_ > max_nesting)
            fail("expected at most " + std::to_string(max_nesting) + " nested parts in an expression");
        unary();
        for (const BinaryOperator* next = peek_operator(); next != nullptr && next->precedence >= lowest;
             next = peek_operator()) {
            at_ += next->symbol.size();
            binary(next->precedence + 1);
            emit(next->op);
        }
        --nesting_;
    }

    void unary() {
        if (++nesting_ > max_nesting)
            fail("expected at most " + std::to_string(max_nesting) + " nested parts in an expression");
        if (expression_.postfix.size() >= max_nodes)
            fail("expected at most " + std::to_string(max_nodes) + " numbers, names and operators in an expression");
        if (take("-")) {
            skip_blanks();
            const bool literal = at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.');
            const std::size_t first = expression_.postfix.size();
            unary();
            // -3 is a number, -3^2 and -(3) are negations
            if (literal && expression_.postfix.size() == first + 1) {
                expression_.postfix.back().number = -expression_.postfix.back().number;
            } else {
                emit(Op::negate);
            }
        } else if (peek_not()) {
            at_ += 1;
            unary();
            emit(Op::logical_not);
        } else {
            power();
        }
        --nesting_;
    }
    bool peek_not() {
        skip_blanks();
        return text_.substr(at_).starts_with('!') && !text_.substr(at_).starts_with("!=");
    }

    void power() {
        atom();
        if (take("^")) {
            unary();  // right to left, and 2^-1 is allowed
            emit(Op::power);
        }
    }

    void atom() {
        skip_blanks();
        if (at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.')) return number();
        if (at_ < text_.size() && starts_name(text_[at_])) return name_or_call();
        if (take("(")) {
            binary(1);
            if (!take(")")) fail("expected ')', found " + found());
            return;
        }
        fail("expected a number, a name or '(', found " + found());
    }

    void number() {
        double value = 0;
        const auto result = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
        if (result.ec == std::errc::result_out_of_range) fail("expected a number between 1e-307 and 1e308 in size");
        if (result.ec != std::errc{}) fail("expected a number, found " + found());
        at_ = static_cast<std::size_t>(result.ptr - text_.data());
        expression_.postfix.push_back({Op::number, value, {}, 0});
    }

    void name_or_call() {
        const std::size_t start = at_;
        while (at_ < text_.size() && continues_name(text_[at_])) ++at_;
        std::string name(text_.substr(start, at_ - start));
        if (form_.queries && at_ < text_.size() && text_[at_] == '.') return dotted_name(std::move(name));
        if (!take("(")) {
            expression_.postfix.push_back({Op::name, 0, std::move(name), 0});
            return;
        }
        skip_blanks();
        if (form_.queries && at_ < text_.size() && text_[at_] == '"') return name_with_text(std::move(name));
        call(std::move(name), start);
    }

    /// F1.vector1.x
    void dotted_name(std::string name) {
        while (at_ < text_.size() && text_[at_] == '.') {
            name += text_[at_++];
            if (at_ >= text_.size() || !starts_name(text_[at_])) fail("expected a name behind the '.', found " + found());
            while (at_ < text_.size() && continues_name(text_[at_])) name += text_[at_++];
        }
        expression_.postfix.push_back({Op::name, 0, std::move(name), 0});
    }

    /// count("leaf")
    void name_with_text(std::string name) {
        const std::size_t end = text_.find_first_of("\"\n", at_ + 1);
        if (end == std::string_view::npos || text_[end] != '"') fail("expected a closing quotation mark for this one");
        name += '(';
        name += text_.substr(at_, end + 1 - at_);
        name += ')';
        at_ = end + 1;
        if (!take(")")) fail("expected ')', found " + found());
        expression_.postfix.push_back({Op::name, 0, std::move(name), 0});
    }

    void call(std::string name, std::size_t start) {
        const ExpressionFunction* function = find_expression_function(name);
        if (function == nullptr || (function->only_with_queries && !form_.queries)) {
            fail_at(start, "expected a function such as sin, sqrt or min, found '" + name + "'" +
                               did_you_mean(name, expression_function_names(form_.queries)));
        }
        int count = 0;
        if (!take(")")) {
            do {
                binary(1);
                ++count;
            } while (take(","));
            if (!take(")")) fail("expected ',' or ')', found " + found());
        }
        if (!takes(*function, count)) {
            fail_at(start, "expected " + arguments_text(*function) + " argument(s) for " + name + ", found " +
                               std::to_string(count));
        }
        expression_.postfix.push_back({Op::call, 0, std::move(name), count});
    }

    static std::string arguments_text(const ExpressionFunction& function) {
        if (function.at_least == 0) return "no or " + std::to_string(function.at_most);
        std::string least = std::to_string(function.at_least);
        if (function.at_most == function.at_least) return least;
        return function.at_most == max_function_arguments ? least + " or more"
                                                          : least + " to " + std::to_string(function.at_most);
    }
};

struct TextPart {
    std::string text;
    int precedence = atom_precedence;
};

std::string in_parentheses_if(bool needed, const std::string& text) {
    if (!needed) return text;
    std::string result = "(";
    result += text;
    return result += ')';
}

TextPart pop(std::vector<TextPart>& parts) {
    TextPart last = parts.empty() ? TextPart{"0"} : std::move(parts.back());
    if (!parts.empty()) parts.pop_back();
    return last;
}

TextPart binary_text(const BinaryOperator& info, TextPart left, const TextPart& right) {
    const bool is_power = info.op == Op::power;
    const bool left_needs = is_power ? left.precedence <= info.precedence : left.precedence < info.precedence;
    // moved when it can be: a sum of many terms is put together in linear time
    std::string text = left_needs ? in_parentheses_if(true, left.text) : std::move(left.text);
    const bool spaced = info.precedence < 4;  // arithmetic stands close, comparisons and logic apart
    if (spaced) text += ' ';
    text += info.symbol;
    if (spaced) text += ' ';
    const bool right_needs = is_power ? right.precedence < unary_precedence : right.precedence <= info.precedence;
    text += in_parentheses_if(right_needs, right.text);
    return {std::move(text), info.precedence};
}

TextPart unary_text(std::string_view sign, const TextPart& operand, bool bare_number) {
    const bool needed = operand.precedence < unary_precedence || bare_number;
    std::string text(sign);
    text += in_parentheses_if(needed, operand.text);
    return {std::move(text), unary_precedence};
}

TextPart call_text(const Expression::Node& node, std::vector<TextPart>& parts) {
    std::vector<std::string> arguments(static_cast<std::size_t>(node.arguments));
    for (auto argument = arguments.rbegin(); argument != arguments.rend(); ++argument) *argument = pop(parts).text;
    std::string text = node.name + '(';
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (i > 0) text += ", ";
        text += arguments[i];
    }
    return {text + ')', atom_precedence};
}

}  // namespace

Expression parse_expression(std::string_view text, const SourcePlace& place, const ExpressionForm& form) {
    return Parser(text, place, form).parse();
}

Expression parse_expression_before(std::string_view text, const SourcePlace& place, const ExpressionForm& form,
                                   std::size_t& length) {
    return Parser(text, place, form).parse_before(length);
}

std::string to_text(const Expression& expression) {
    std::vector<TextPart> parts;
    for (std::size_t i = 0; i < expression.postfix.size(); ++i) {
        const Expression::Node& node = expression.postfix[i];
        switch (node.op) {
            case Op::number:
                parts.push_back({number_text(node.number), node.number < 0 ? unary_precedence : atom_precedence});
                break;
            case Op::name:
                parts.push_back({node.name, atom_precedence});
                break;
            case Op::negate: {
                const bool literal =
                    i > 0 && expression.postfix[i - 1].op == Op::number && expression.postfix[i - 1].number >= 0;
                parts.push_back(unary_text("-", pop(parts), literal));
                break;
            }
            case Op::logical_not:
                parts.push_back(unary_text("!", pop(parts), false));
                break;
            case Op::call:
                parts.push_back(call_text(node, parts));
                break;
            default: {
                TextPart right = pop(parts);
                TextPart left = pop(parts);
                parts.push_back(
                    binary_text(*std::ranges::find(binary_operators, node.op, &BinaryOperator::op), std::move(left), right));
            }
        }
    }
    return pop(parts).text;
}

}  // namespace rinceau
