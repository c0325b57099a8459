#include "exports/houdini.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "exports/carried_state.h"
#include "exports/drawn_terminal.h"
#include "exports/houdini_syntax.h"
#include "exports/plain_decimal.h"
#include "exports/prepared_grammar.h"
#include "exports/single_characters.h"
#include "exports/target_names.h"
#include "exports/turtle_walk.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

/// Letters that Houdini's turtle gives no meaning.
constexpr std::string_view free_characters = "ABCDEINOPQRSUVWXYZbcdeijklmnopqrstuvwxyz";
/// Parameters by their place: letters that its expressions give no meaning.
constexpr std::string_view parameter_letters = "mnpqruvwkjlo";
/// J(s,x,a,b,c) is documented to take five arguments, no module more.
constexpr std::size_t most_parameters = 5;

/// Decompositions, rewriting and homomorphisms in this order, as rules of one kind: without contexts it is the same.
Grammar of_one_kind(Grammar grammar) {
    const auto rank = [](const Production& production) {
        return production.kind == ProductionKind::decomposition ? 0 : production.kind == ProductionKind::rewriting ? 1 : 2;
    };
    std::ranges::stable_sort(grammar.productions, {}, rank);
    for (Production& production : grammar.productions) production.kind = ProductionKind::rewriting;
    return grammar;
}

class HoudiniWriter {
  public:
    HoudiniWriter(const PreparedGrammar& prepared, const ExportOptions& options)
        : prepared_(prepared),
          options_(options),
          scaled_(remembers(prepared.grammar, TurtleMemory::scale)),
          symbols_(single_characters(all_symbols(prepared.grammar), free_characters)) {}

    Export write() {
        if (has_contexts(prepared_.grammar)) throw RulesLost{"contexts in Houdini do not look past brackets"};
        std::optional<Grammar> grammar =
            scaled_ ? carried(prepared_.grammar, TurtleMemory::scale) : std::optional<Grammar>(prepared_.grammar);
        if (!grammar)
            throw RulesLost{"Houdini needs the scale as an argument, and a symbol changes it for what stands after it"};
        grammar_ = of_one_kind(std::move(*grammar));
        const std::string premise = string_text(grammar_.axiom, {});
        std::string rules;
        int number = 0;
        for (const std::string& rule : rules_text()) rules += "Rule " + std::to_string(++number) + ": " + rule + '\n';
        // one more for the drawings
        const int generations = steps_to_the_end(of_one_kind(prepared_.grammar), {}) + 1;
        return {
            .bytes = head_text() + "Generations: " + std::to_string(generations) + "\nPremise: " + premise + '\n' + rules,
            .notes = prepared_.notes};
    }

  private:
    /// A symbol with a number of arguments: all its rules have the same parameters.
    struct Family {
        std::string symbol;
        std::size_t arity = 0;
        friend auto operator<=>(const Family&, const Family&) = default;
    };

    const PreparedGrammar& prepared_;
    const ExportOptions& options_;
    bool scaled_;
    std::map<std::string, SingleCharacter, std::less<>> symbols_;
    Grammar grammar_;

    std::string head_text() const {
        std::string text = "# " + one_line(prepared_.grammar.title.empty() ? options_.name : prepared_.grammar.title) + '\n';
        text +=
            "# Written by Rinceau for Houdini's L-System SOP: set Type to Skeleton (lines) or Tube, Generations, Premise "
            "and the\n"
            "# rules as below, Step Size 1, Thickness 1, Angle 90. The turtle starts at the origin and heads +Y; - turns "
            "left,\n"
            "# /(180) mirrors what follows about the heading.\n";
        for (const std::string& comment : prepared_.grammar.comments) text += "# " + one_line(comment) + '\n';
        text += "# Symbols:\n";
        for (const auto& [name, symbol] : symbols_) {
            const std::string number = symbol.number < 0 ? "" : '(' + std::to_string(symbol.number) + ",..)";
            text += "#   " + std::string(1, symbol.character) + number + " is " + name + '\n';
        }
        if (prepared_.styled) text += "# The number of the style in force is an argument of every symbol.\n";
        if (scaled_) text += "# The last argument of every symbol is the scale.\n";
        return text;
    }

    /// Names become letters by their place, constants what they stand for.
    Expression with_letters(const Expression& source, const std::vector<std::string>& parameters) const {
        Expression result;
        for (const Expression::Node& node : source.postfix) {
            if (node.op != Expression::Op::name) {
                result.postfix.push_back(node);
                continue;
            }
            const auto parameter = std::ranges::find(parameters, node.name);
            const auto constant = std::ranges::find(grammar_.constants, node.name, &Constant::name);
            if (parameter != parameters.end()) {
                result.postfix.push_back(node);
                result.postfix.back().name = parameter_letters[static_cast<std::size_t>(parameter - parameters.begin())];
            } else if (constant != grammar_.constants.end()) {
                const Expression value = with_letters(constant->value, {});
                result.postfix.insert(result.postfix.end(), value.postfix.begin(), value.postfix.end());
            } else {
                result.postfix.push_back(node);  // pi and e
            }
        }
        return result;
    }

    std::string expression(const Expression& source, const std::vector<std::string>& parameters,
                           ExpressionSyntax syntax) const {
        syntax.name = [](std::string_view name) -> std::optional<std::string> {
            if (name.size() == 1 && parameter_letters.find(name.front()) != std::string_view::npos) return std::string(name);
            return std::nullopt;
        };
        std::optional<std::string> text = write_expression(with_letters(source, parameters), syntax);
        if (!text) throw RulesLost{"Houdini has no counterpart of " + to_text(source)};
        return std::move(*text);
    }

    std::string symbol_text(const std::string& name, std::string arguments) const {
        const SingleCharacter& symbol = symbols_.find(name)->second;
        if (symbol.number >= 0) arguments = std::to_string(symbol.number) + (arguments.empty() ? "" : ',' + arguments);
        return symbol.character + (arguments.empty() ? std::string() : '(' + arguments + ')');
    }

    std::string module_text(const ModuleTemplate& module, const std::vector<std::string>& parameters) const {
        std::string arguments;
        for (const Expression& argument : module.arguments)
            arguments += (arguments.empty() ? "" : ",") + expression(argument, parameters, houdini_argument_syntax());
        const TurtleCommandInfo* command = find_turtle_command(module.symbol);
        if (command == nullptr) {
            if (module.arguments.size() + shared(module.symbol) > most_parameters)
                throw RulesLost{"Houdini's modules have at most 5 arguments, the scale among them"};
            return symbol_text(module.symbol, arguments);
        }
        switch (command->command) {
            case TurtleCommand::left:
                return "-(" + arguments + ')';
            case TurtleCommand::right:
                return "+(" + arguments + ')';
            case TurtleCommand::forward:
                return "f(" + arguments + ')';
            case TurtleCommand::mirror:
                return "/(180)";
            case TurtleCommand::push:
            case TurtleCommand::pop:
                return module.symbol;
            default:
                return {};  // layers; scales and styles are arguments
        }
    }

    std::string string_text(const std::vector<ModuleTemplate>& modules, const std::vector<std::string>& parameters) const {
        std::string text;
        for (const ModuleTemplate& module : modules) text += module_text(module, parameters);
        return text;
    }

    std::size_t shared(const std::string& symbol) const { return symbols_.find(symbol)->second.number >= 0 ? 1 : 0; }

    /// symbol(m,n,..), behind the number of one that shares its character: a letter after those in use.
    std::string head_of(const Family& family, std::vector<std::string>& conditions) const {
        std::string names;
        if (shared(family.symbol) != 0) {
            names = parameter_letters[family.arity];
            const std::string number = std::to_string(symbols_.find(family.symbol)->second.number);
            conditions.push_back("!((" + names + '<' + number + ")|(" + names + '>' + number + "))");
        }
        for (std::size_t i = 0; i < family.arity; ++i)
            names += (names.empty() ? "" : ",") + std::string(1, parameter_letters[i]);
        return symbols_.find(family.symbol)->second.character + (names.empty() ? std::string() : '(' + names + ')');
    }

    static std::string rule_text(const std::string& head, const std::vector<std::string>& conditions,
                                 const std::string& successor) {
        std::string condition;
        for (const std::string& part : conditions)
            condition += (condition.empty() ? "" : "&") + (conditions.size() > 1 ? '(' + part + ')' : part);
        return head + (condition.empty() ? "" : ':' + condition) + '=' + successor;
    }

    /// Which rule applies does not depend on their order: each has the conditions of those before it, denied.
    std::vector<std::string> rules_text() const {
        std::vector<std::string> rules;
        for (const Family& family : families()) {
            std::vector<std::string> conditions;
            const std::string head = head_of(family, conditions);
            bool open = true;
            for (const Production& production : grammar_.productions) {
                if (!open || production.symbol != family.symbol || production.parameters.size() != family.arity) continue;
                std::vector<std::string> own = conditions;
                open = production.condition.has_value();
                if (open) {
                    own.push_back(expression(*production.condition, production.parameters, houdini_condition_syntax()));
                    conditions.push_back("!(" + own.back() + ')');
                }
                rules.push_back(rule_text(head, own, string_text(production.successor, production.parameters)));
            }
            const auto terminal = std::ranges::find(grammar_.terminals, family.symbol, &Terminal::symbol);
            if (open && terminal != grammar_.terminals.end()) add_drawing_rules(family, head, conditions, *terminal, rules);
        }
        return rules;
    }

    std::set<Family> families() const {
        std::set<Family> families;
        for (const std::string& symbol : all_symbols(grammar_)) {
            for (const std::size_t arity : arities_of(grammar_, symbol)) families.insert({symbol, arity});
        }
        return families;
    }

    void add_drawing_rules(const Family& family, const std::string& head, const std::vector<std::string>& conditions,
                           const Terminal& terminal, std::vector<std::string>& rules) const {
        const std::string scale = scaled_ ? std::string("*") + parameter_letters[family.arity - 1] : "";
        for (const StyleChoice& choice : styles_of(prepared_, terminal)) {
            std::vector<std::string> own = conditions;
            if (prepared_.styled) {
                const char style = parameter_letters[family.arity - (scaled_ ? 2 : 1)];
                const std::string number = std::to_string(choice.number);
                own.push_back(std::string("!((") + style + '<' + number + ")|(" + style + '>' + number + "))");
            }
            rules.push_back(rule_text(head, own, drawing_text(terminal, choice.style, scale)));
        }
    }

    static std::string turn_text(double turn) {
        return turn == 0 ? "" : (turn < 0 ? "+(" : "-(") + plain_decimal(std::abs(turn)) + ')';
    }

    static std::string color_text(Color color) {
        constexpr double whole = 255;
        return "a(\"Cd\"," + plain_decimal(color.red / whole, 8) + ',' + plain_decimal(color.green / whole, 8) + ',' +
               plain_decimal(color.blue / whole, 8) + ')';
    }

    /// [ ] if nothing is drawn.
    static std::string drawing_text(const Terminal& terminal, const Style& style, const std::string& scale) {
        const DrawnTerminal drawn = drawn_terminal(terminal, style);
        std::string fill;
        for (const Polygon& polygon : drawn.polygons) fill += polygon_text(polygon, *drawn.fill, scale);
        std::string line;
        for (const Path& path : drawn.outlines) line += line_text(path, terminal, drawn, scale);
        return drawn.line_first ? line + fill : fill + line;
    }

    static std::string polygon_text(const Polygon& polygon, Color color, const std::string& scale) {
        std::string text = '[' + color_text(color);
        const std::vector<WalkStep> steps = walk_along(polygon);
        for (std::size_t i = 0; i < steps.size(); ++i) {
            text += turn_text(steps[i].turn);
            if (steps[i].length > 0) text += "f(" + plain_decimal(steps[i].length) + scale + ')';
            text += i == 0 ? "{." : ".";
        }
        return text + "}]";
    }

    static std::string line_text(const Path& path, const Terminal& terminal, const DrawnTerminal& drawn,
                                 const std::string& scale) {
        const double deviation = flatness_share * std::max(outline_size(terminal), 1e-300);
        std::string text = '[' + color_text(*drawn.line);
        const std::string width = ',' + plain_decimal(drawn.width) + (drawn.fixed_width ? "" : scale);
        const std::vector<WalkStep> steps = walk_along(polyline_of(path, deviation));
        for (std::size_t i = 0; i < steps.size(); ++i) {
            text += turn_text(steps[i].turn);
            if (steps[i].length > 0)
                text += (i == 0 ? "f(" : "F(") + plain_decimal(steps[i].length) + scale + (i == 0 ? "" : width) + ')';
        }
        return text + ']';
    }
};

}  // namespace

Export to_houdini(const Grammar& grammar, const ExportOptions& options) {
    return write_prepared(grammar, options, "Houdini",
                          [&](const PreparedGrammar& prepared) { return HoudiniWriter(prepared, options).write(); });
}

}  // namespace rinceau
