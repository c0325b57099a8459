#include "growth/surface/shape_grammar_text.h"

#include "growth/surface/shape_commands.h"
#include "lsystem/number_text.h"
#include "lsystem/statement.h"

namespace rinceau {

namespace {

std::string group_text(const ShapeCommand& command, std::string_view word) {
    std::string text(word);
    text += '{';
    for (std::size_t i = 0; i < command.groups.size(); ++i) {
        if (i > 0) text += " | ";
        text += commands_text(command.groups[i]);
    }
    return text + '}';
}

std::string command_text(const ShapeCommand& command) {
    if (command.verb == ShapeVerb::push) return "[";
    if (command.verb == ShapeVerb::pop) return "]";
    std::string text = command.verb == ShapeVerb::symbol ? command.name : std::string(shape_command(command.verb).word);
    if (!command.groups.empty()) return group_text(command, text);
    if (command.arguments.empty() && !command.has_text) return text;
    text += '(';
    if (command.has_text) text += in_quotes(command.text);
    for (std::size_t i = 0; i < command.arguments.size(); ++i) {
        if (i > 0 || command.has_text) text += ", ";
        text += to_text(command.arguments[i]);
    }
    return text + ')';
}

std::string settings_text(const ShapeSource& source) {
    std::string text;
    for (const auto& [key, value] : source.numbers)
        if (key != "value" || source.kind.empty() == false) text += ' ' + key + " = " + to_text(value);
    for (const auto& [key, word] : source.words) text += ' ' + key + " = " + (is_name(word) ? word : in_quotes(word));
    return text;
}

std::string source_text(std::string_view keyword, const ShapeSource& source) {
    std::string text(keyword);
    text += ' ' + source.name + " = " + source.kind;
    if (!source.text.empty()) text += ' ' + in_quotes(source.text);
    return text + settings_text(source) + '\n';
}

std::string option_text(const ShapeSource& option) {
    std::string text = "option " + option.name + " = ";
    const auto value = option.numbers.find("value");
    if (value != option.numbers.end()) {
        text += to_text(value->second);
    } else {
        text += is_name(option.text) ? option.text : in_quotes(option.text);
    }
    return text + settings_text(option) + '\n';
}

std::string where_text(const ShapeAxiom& axiom) {
    switch (axiom.where) {
        case ShapeAxiom::Where::vertex:
            return "vertex";
        case ShapeAxiom::Where::nearest:
            return "nearest";
        case ShapeAxiom::Where::scatter:
            return "scatter";
        case ShapeAxiom::Where::each:
            break;
    }
    return "each " + axiom.field;
}

/// Numbers stand side by side there: what is more than one operand is in parentheses, and so is a name before a parenthesis,
/// or it would read as a function.
std::string operands_text(const std::vector<Expression>& expressions) {
    std::string text;
    for (auto expression = expressions.rbegin(); expression != expressions.rend(); ++expression) {
        const bool name = expression->postfix.front().op == Expression::Op::name;
        const bool operand = expression->postfix.size() == 1 && !(name && text.starts_with(" ("));
        text.insert(0, operand ? ' ' + to_text(*expression) : " (" + to_text(*expression) + ')');
    }
    return text;
}

}  // namespace

std::string commands_text(const std::vector<ShapeCommand>& commands) {
    std::string text;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        const bool close = i == 0 || commands[i - 1].verb == ShapeVerb::push || commands[i].verb == ShapeVerb::pop;
        if (!close) text += ' ';
        text += command_text(commands[i]);
    }
    return text;
}

std::string statement_text(const ShapeRule& rule) {
    std::string text = rule.id.empty() ? rule.symbol : rule.id + ": " + rule.symbol;
    for (std::size_t i = 0; i < rule.parameters.size(); ++i) text += (i == 0 ? "(" : ", ") + rule.parameters[i];
    if (!rule.parameters.empty()) text += ')';
    if (rule.condition) {
        const bool single_name = rule.condition->postfix.size() == 1;  // or it would read as a symbol behind an id
        text += " : " + (single_name ? '(' + to_text(*rule.condition) + ')' : to_text(*rule.condition));
    }
    text += " ~";
    if (!rule.successor.empty()) text += ' ' + commands_text(rule.successor);
    if (rule.probability) text += " : " + to_text(*rule.probability);
    if (rule.priority != 0) text += " @ " + number_text(rule.priority);
    return text;
}

std::string statement_text(const ShapeAxiom& axiom) {
    return "axiom " + where_text(axiom) + operands_text(axiom.numbers) + ' ' + commands_text(axiom.commands);
}

std::string to_text(const ShapeGrammar& grammar) {
    std::string text;
    for (const std::string& line : grammar.comments) text += comment_line(line);
    if (!grammar.comments.empty()) text += '\n';
    for (const ShapeParam& param : grammar.params) {
        text += commented(param.comment);
        text += "param " + param.name + " = " + to_text(param.value) + '\n';
    }
    for (const ShapeSource& field : grammar.fields) {
        text += commented(field.comment);
        text += source_text("field", field);
    }
    for (const ShapeSource& shape : grammar.shapes) {
        text += commented(shape.comment);
        text += source_text("shape", shape);
    }
    for (const auto& [name, option] : grammar.options) {
        text += commented(option.comment);
        text += option_text(option);
    }
    for (const ShapeAxiom& axiom : grammar.axioms) {
        text += commented(axiom.comment);
        text += statement_text(axiom) + '\n';
    }
    for (const ShapeRule& rule : grammar.rules) {
        text += commented(rule.comment);
        text += statement_text(rule) + '\n';
    }
    return text;
}

}  // namespace rinceau
