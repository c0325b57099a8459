#include "growth/surface/parse_shape_rule.h"

#include <algorithm>

#include "growth/surface/parse_shape_commands.h"
#include "growth/surface/shape_commands.h"
#include "growth/surface/shape_statements.h"
#include "lsystem/number_text.h"

namespace rinceau {

namespace {

constexpr std::size_t most_parameters = 1000;  // they are compared with each other

bool take_rule_sign(Scanner& scanner) { return scanner.take(rule_sign) || scanner.take(rule_arrow); }

bool at_rule_sign(Scanner& scanner) { return scanner.peek(rule_sign) || scanner.peek(rule_arrow); }

/// Behind the ':' of `a : ..`: does a symbol follow, with or without parameters, and then a condition or the successor?
bool symbol_follows(Scanner& scanner) {
    if (scanner.peek_name().empty()) return false;
    scanner.name("a symbol");
    if (scanner.take("(")) {
        do {
            if (scanner.peek_name().empty()) return false;
            scanner.name("a parameter");
        } while (scanner.take(","));
        if (!scanner.take(")")) return false;
    }
    return scanner.peek(":") || at_rule_sign(scanner);
}

/// A rule's name may be a number.
std::string word_or_number(Scanner& scanner) {
    if (!scanner.peek_name().empty()) return scanner.name("a name");
    const std::size_t at = scanner.position();
    const std::string& text = scanner.statement().text;
    if (at >= text.size() || !is_digit(text[at])) return {};
    return std::to_string(scanner.integer("a whole number"));
}

std::string id_before_colon(Scanner& scanner) {
    const std::size_t start = scanner.position();
    std::string id = word_or_number(scanner);
    bool is_id = !id.empty() && scanner.take(":");
    const std::size_t behind = scanner.position();
    is_id = is_id && symbol_follows(scanner);
    scanner.go_to(is_id ? behind : start);
    return is_id ? id : std::string();
}

std::vector<std::string> parse_parameters(Scanner& scanner) {
    std::vector<std::string> parameters;
    if (!scanner.take("(") || scanner.take(")")) return parameters;
    do {
        const SourcePlace place = scanner.place();
        if (parameters.size() == most_parameters) scanner.fail("at most " + std::to_string(most_parameters) + " parameters");
        parameters.push_back(scanner.name("the name of a parameter"));
        if (std::ranges::count(parameters, parameters.back()) > 1)
            throw InputError(place, "expected another name, found the parameter '" + parameters.back() + "' twice");
    } while (scanner.take(","));
    if (!scanner.take(")")) scanner.fail("',' or ')' behind a parameter");
    return parameters;
}

}  // namespace

ShapeRule parse_shape_rule(Scanner& scanner) {
    ShapeRule rule;
    rule.place = scanner.place();
    rule.comment = scanner.statement().comment;
    rule.id = id_before_colon(scanner);
    const SourcePlace symbol_place = scanner.place();
    rule.symbol = scanner.name("a statement: param, shape, field, option, axiom or a rule such as A ~ B");
    if (is_reserved_word(rule.symbol))
        throw InputError(symbol_place, "expected a symbol of your own before ~, found the word '" + rule.symbol + "'");
    rule.parameters = parse_parameters(scanner);
    if (scanner.take(":")) rule.condition = parse_shape_expression(scanner);
    if (!take_rule_sign(scanner)) scanner.fail(rule.condition ? "'~' behind the condition" : "':' or '~' behind the symbol");
    rule.successor = parse_shape_commands(scanner, ":@");
    if (scanner.take(":")) rule.probability = parse_shape_expression(scanner);
    if (scanner.take("@")) rule.priority = scanner.number();
    scanner.expect_end("the end of the rule");
    return rule;
}

}  // namespace rinceau
