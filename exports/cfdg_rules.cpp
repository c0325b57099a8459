#include "exports/cfdg_rules.h"

#include <algorithm>
#include <map>

#include "exports/cfdg_symbols.h"
#include "exports/inlined_moves.h"
#include "exports/measured_modules.h"
#include "exports/number.h"
#include "geometry/angle.h"
#include "lsystem/derivation_graph.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

/// What the rules cannot say; caught where the export begins.
struct NotByRules {};

using Scope = CfdgScope;

class RulesWriter {
  public:
    RulesWriter(const Grammar& grammar, const DeriveOptions& options, bool live_random, NoteList& notes)
        : grammar_(grammar),
          live_(live_random),
          notes_(notes),
          calls_(grammar),
          measure_(grammar, options),
          symbols_(grammar, options, live_random) {}

    std::string write() {
        if (!calls_.balanced()) throw NotByRules();
        const Scope axiom = symbols_.axiom_scope();
        std::string shapes = "shape " + axiom.shape + " {\n" + calls_text(grammar_.axiom, axiom, "  ") + "}\n\n";
        for (const auto& [signature, scope] : symbols_.scopes) {
            if (calls_.draws(signature)) shapes += shape_text(signature, scope) + '\n';
        }
        std::string counts;
        while (!counts_wanted_.empty()) counts += count_function(*counts_wanted_.begin());
        if (!counts.empty() && static_cast<double>(symbols_.placements) * symbols_.depth > most_count_work)
            throw NotByRules();
        return cfdg_head(grammar_, axiom.shape, symbols_.most_natural) + constants_text() + shapes + dispatch_ + paths_ +
               functions_ + counts;
    }

  private:
    static constexpr double most_count_work =
        2e7;  // calls of the functions that count; Context Free makes a million a second

    const Grammar& grammar_;
    bool live_;
    NoteList& notes_;
    CallGraph calls_;
    MeasuredModules measure_;
    CfdgSymbols symbols_;
    std::map<std::pair<int, int>, std::string> look_names_;
    std::map<int, std::string> dispatch_names_;
    std::map<Signature, std::string> count_names_;
    std::set<Signature> counts_wanted_;
    std::string dispatch_;
    std::string paths_;
    std::string functions_;

    // ---- expressions

    CfdgText text_of(const Expression& expression, const Scope& scope) const {
        const std::optional<CfdgText> text = cfdg_expression(expression, scope.names);
        if (!text) throw NotByRules();
        return *text;
    }
    std::string operand_of(const Expression& expression, const Scope& scope) const {
        const CfdgText text = as_number(text_of(expression, scope));
        const bool number = expression.postfix.size() == 1 && expression.postfix.front().op == Expression::Op::number;
        return number ? text.text : '(' + text.text + ')';
    }

    std::string declared_parameters(const Scope& scope, bool all_numbers) const {
        std::string text;
        for (std::size_t i = 0; i < scope.parameters.size(); ++i) {
            text += text.empty() ? "" : ", ";
            text += scope.natural[i] && !all_numbers ? "natural " : "number ";
            text += scope.names.at(scope.parameters[i]);
        }
        if (symbols_.styled) text += std::string(text.empty() ? "" : ", ") + "number " + symbols_.style_name;
        return text;
    }
    std::string own_arguments(const Scope& scope) const {
        std::string text;
        for (const std::string& parameter : scope.parameters) text += (text.empty() ? "" : ", ") + scope.names.at(parameter);
        if (symbols_.styled) text += (text.empty() ? "" : ", ") + symbols_.style_name;
        return text;
    }

    /// Context Free takes no arithmetic on parameters where a number is wanted, but calls of functions that are defined
    /// later.
    std::string number_argument(const std::string& text, const Scope& scope, const std::string& wish) {
        const bool simple = text.find_first_of(" +-*/^(") == std::string::npos;
        const bool literal = text.find_first_not_of("-.e0123456789") == std::string::npos;
        const bool without_parameters = scope.parameters.empty() && scope.style == "0";
        if (simple || literal || without_parameters) return text;
        const std::string name = symbols_.names.take(wish);
        functions_ += name + '(' + declared_parameters(scope, false) + ") = " + text + '\n';
        return name + '(' + own_arguments(scope) + ')';
    }

    std::string constants_text() const {
        std::string text;
        Scope scope{.names = symbols_.constants};
        for (const Constant& constant : grammar_.constants)
            text += symbols_.constants.at(constant.name) + " = " + as_number(text_of(constant.value, scope)).text + '\n';
        return text.empty() ? text : text + '\n';
    }

    // ---- terminals

    std::string look_name(int terminal, int style) {
        const auto [place, added] = look_names_.try_emplace({terminal, style});
        if (!added) return place->second;
        const Terminal& drawn = grammar_.terminals[static_cast<std::size_t>(terminal)];
        const Style painted = look_style(grammar_, {terminal, style});
        note_losses(drawn, painted, notes_);
        if (!cfdg_draws(drawn, painted)) return {};
        const bool alone = symbols_.looks[terminal].size() < 2;
        place->second = symbols_.names.take(alone ? drawn.symbol : drawn.symbol + "_style" + std::to_string(style));
        paths_ += cfdg_path(place->second, drawn, painted) + '\n';
        return place->second;
    }

    /// A shape that chooses the path by the style.
    std::string dispatch_name(int terminal) {
        const auto [place, added] = dispatch_names_.try_emplace(terminal);
        if (!added) return place->second;
        place->second = symbols_.names.take(grammar_.terminals[static_cast<std::size_t>(terminal)].symbol);
        std::string body;
        for (const int style : symbols_.looks[terminal]) {
            const std::string name = look_name(terminal, style);
            if (name.empty()) continue;
            body += std::string(body.empty() ? "  " : "  else ") + "if (" + symbols_.style_name +
                    " == " + std::to_string(style) + ") { " + name + " [] }\n";
        }
        dispatch_ += "shape " + place->second + "(number " + symbols_.style_name + ") {\n" + body + "}\n\n";
        return place->second;
    }

    std::string terminal_call(int terminal, const std::string& style, const Scope& scope) {
        const std::set<int>& styles = symbols_.looks[terminal];
        if (styles.empty()) return {};
        if (!symbols_.styled || styles.size() == 1) return look_name(terminal, symbols_.styled ? *styles.begin() : 0);
        const auto is_style = [&](int number) { return std::to_string(number) == style; };
        const auto known = std::ranges::find_if(styles, is_style);
        if (known != styles.end()) return look_name(terminal, *known);
        const std::string name = dispatch_name(terminal);
        return name + '(' + number_argument(style, scope, name + "_style") + ')';
    }

    // ---- strings

    struct Turtle {
        std::string adjustments;
        std::string style;
    };

    void append(Turtle& turtle, const std::string& name, const std::string& value) const {
        turtle.adjustments += (turtle.adjustments.empty() ? "" : " ") + name + ' ' + value;
    }

    static std::string negative(const std::string& operand) {
        if (operand.starts_with('-')) return operand.substr(1);
        return operand.starts_with('(') ? "(-" + operand + ')' : '-' + operand;
    }

    void obey(Turtle& turtle, std::vector<Turtle>& stack, const ModuleTemplate& module, const Scope& scope) const {
        const std::string value = module.arguments.empty() ? "" : operand_of(module.arguments.front(), scope);
        switch (find_turtle_command(module.symbol)->command) {
            case TurtleCommand::left:
                return append(turtle, "r", value);
            case TurtleCommand::right:
                return append(turtle, "r", negative(value));
            case TurtleCommand::forward:
                return append(turtle, "y", value);
            case TurtleCommand::scale:
                return append(turtle, "s", value);
            case TurtleCommand::mirror:
                return append(turtle, "flip", "90");
            case TurtleCommand::push:
                return stack.push_back(turtle);
            case TurtleCommand::pop:
                turtle = std::move(stack.back());
                return stack.pop_back();
            case TurtleCommand::style:
                turtle.style = as_number(text_of(module.arguments.front(), scope)).text;
                return;
            case TurtleCommand::layer:
                return append(turtle, "z", '(' + number_of(layer_height()) + '*' + value + ')');
            case TurtleCommand::fill:
            case TurtleCommand::stroke:
                throw NotByRules();
        }
    }

    double layer_height() const { return std::max(1.0, static_cast<double>(symbols_.placements)); }

    std::string calls_text(const std::vector<ModuleTemplate>& string, const Scope& scope, const std::string& indent) {
        std::string text;
        Turtle turtle{.style = scope.style};
        std::vector<Turtle> stack;
        double below = 0;               // things drawn before, ..
        std::vector<std::string> more;  // .. and the calls that count the rest of them
        for (std::size_t i = 0; i < string.size(); ++i) {
            const ModuleTemplate& module = string[i];
            if (find_turtle_command(module.symbol) != nullptr) {
                obey(turtle, stack, module, scope);
                continue;
            }
            if (calls_.draws(module)) {
                text += call_text(module, turtle, scope, indent, height_text(below, more));
                const auto draw = [&](const ModuleTemplate& later) { return calls_.draws(later); };
                if (!live_ && std::any_of(string.begin() + static_cast<std::ptrdiff_t>(i) + 1, string.end(), draw))
                    count(module, scope, below, more);
            }
            if (!calls_.stays(module) && calls_.matters(string, i)) follow(turtle, module, scope);
        }
        return text;
    }

    static std::string height_text(double below, const std::vector<std::string>& more) {
        std::string text = below != 0 || more.empty() ? number_of(below) : "";
        for (const std::string& call : more) text += (text.empty() ? "" : " + ") + call;
        if (more.empty()) return below == 0 ? "" : text;
        return '(' + text + ')';
    }

    std::string call_text(const ModuleTemplate& module, const Turtle& turtle, const Scope& scope, const std::string& indent,
                          const std::string& height) {
        std::string call;
        if (const auto shape = symbols_.scopes.find(signature_of(module)); shape != symbols_.scopes.end()) {
            call = shape_call(module, shape->second, turtle.style, scope);
        } else {
            call = terminal_call(calls_.terminal_of(module.symbol), turtle.style, scope);
        }
        if (call.empty()) return {};
        Turtle at = turtle;
        if (!height.empty()) append(at, "z", height);
        return indent + call + (at.adjustments.empty() ? " []" : " [[ " + at.adjustments + " ]]") + '\n';
    }

    std::string shape_call(const ModuleTemplate& module, const Scope& called, const std::string& style, const Scope& scope) {
        std::string arguments;
        for (std::size_t i = 0; i < module.arguments.size(); ++i) {
            arguments += arguments.empty() ? "" : ", ";
            const Expression& argument = module.arguments[i];
            arguments += called.natural[i] ? symbols_.natural_text(argument, scope).value()
                                           : number_argument(as_number(text_of(argument, scope)).text, scope,
                                                             called.shape + '_' + called.names.at(called.parameters[i]));
        }
        if (symbols_.styled)
            arguments +=
                (arguments.empty() ? "" : ", ") + number_argument(style, scope, called.shape + '_' + symbols_.style_name);
        return arguments.empty() ? called.shape : called.shape + '(' + arguments + ')';
    }

    /// The turtle goes where the module leaves it: the same everywhere, or not to be said.
    void follow(Turtle& turtle, const ModuleTemplate& module, const Scope& scope) {
        if (!is_constant(module, scope.parameters) || live_) throw NotByRules();
        const std::optional<MeasuredModules::Move> move = measure_.move_of(module);
        if (!move) throw NotByRules();
        const Similarity& pose = move->pose;
        if (pose.translation.x != 0) append(turtle, "x", number_of(pose.translation.x));
        if (pose.translation.y != 0) append(turtle, "y", number_of(pose.translation.y));
        if (arg(pose.linear) != 0) append(turtle, "r", number_of(degrees(arg(pose.linear))));
        if (scale_of(pose) != 1) append(turtle, "s", number_of(scale_of(pose)));
        if (pose.mirrored) append(turtle, "flip", "0");
        if (move->layer != 0) append(turtle, "z", number_of(layer_height() * move->layer));
        if (move->style) turtle.style = std::to_string(*move->style);
    }

    // ---- heights: what is drawn is counted, so that paint order is kept

    void count(const ModuleTemplate& module, const Scope& scope, double& below, std::vector<std::string>& more) {
        if (!symbols_.scopes.contains(signature_of(module))) {
            below += 1;
        } else if (is_constant(module, scope.parameters)) {
            below += static_cast<double>(measure_.placements_of(module));
        } else {
            more.push_back(count_call(module, scope));
        }
    }

    std::string count_call(const ModuleTemplate& module, const Scope& scope) {
        const Signature signature = signature_of(module);
        const auto [place, added] = count_names_.try_emplace(signature);
        if (added) {
            place->second = symbols_.names.take(symbols_.scopes.at(signature).shape + "_count");
            counts_wanted_.insert(signature);
        }
        std::string arguments;
        for (const Expression& argument : module.arguments)
            arguments += (arguments.empty() ? "" : ", ") + as_number(text_of(argument, scope)).text;
        return place->second + '(' + arguments + ')';
    }

    // By value: what is erased may be its own original. NOLINTNEXTLINE(performance-unnecessary-value-param)
    std::string count_function(Signature signature) {
        counts_wanted_.erase(signature);
        const Scope& shape = symbols_.scopes.at(signature);
        std::string text;
        int open = 0;
        bool always = false;
        for (const Production* production : calls_.productions_of(signature)) {
            const Scope scope = symbols_.scope_of(*production, shape);
            double below = 0;
            std::vector<std::string> more;
            for (const ModuleTemplate& module : production->successor) {
                if (find_turtle_command(module.symbol) == nullptr && calls_.draws(module)) count(module, scope, below, more);
            }
            const std::string sum = more.empty() ? number_of(below) : height_text(below, more);
            always = !production->condition;
            if (always) {
                text += sum;
                break;
            }
            text += "if(" + as_condition(text_of(*production->condition, scope)) + ", " + sum + ", ";
            ++open;
        }
        if (!always) text += calls_.terminal_of(signature.first) >= 0 ? "1" : "0";
        text.append(static_cast<std::size_t>(open), ')');
        std::string parameters;
        for (const std::string& parameter : shape.parameters)
            parameters += (parameters.empty() ? "number " : ", number ") + shape.names.at(parameter);
        return count_names_.at(signature) + '(' + parameters + ") = " + text + '\n';
    }

    // ---- shapes

    std::string shape_text(const Signature& signature, const Scope& shape) {
        std::string comment;
        for (const Production* production : calls_.productions_of(signature)) {
            std::string line;
            for (const char c : production->comment + '\n') {
                if (c != '\n') {
                    line += c;
                } else if (!line.empty()) {
                    comment += "// " + line + '\n';
                    line.clear();
                }
            }
        }
        const std::string parameters = declared_parameters(shape, false);
        return comment + "shape " + shape.shape + (parameters.empty() ? "" : '(' + parameters + ')') + " {\n" +
               choices_text(signature, shape) + "}\n";
    }

    std::string choices_text(const Signature& signature, const Scope& shape) {
        const std::vector<const Production*>& productions = calls_.productions_of(signature);
        std::string text;
        for (std::size_t i = 0; i < productions.size(); ++i) {
            const Production& production = *productions[i];
            if (production.weight) return text + weighted_text(signature, shape, i, !text.empty());
            const Scope scope = symbols_.scope_of(production, shape);
            if (!production.condition && text.empty()) return calls_text(production.successor, scope, "  ");
            const std::string body = "{\n" + calls_text(production.successor, scope, "    ") + "  }\n";
            if (!production.condition) return text + "  else " + body;
            text += std::string(text.empty() ? "  " : "  else ") + "if (" +
                    as_condition(text_of(*production.condition, scope)) + ") " + body;
        }
        return text + own_drawing(signature, shape);
    }

    /// A symbol that is drawn where no production applies.
    std::string own_drawing(const Signature& signature, const Scope& shape) {
        const int terminal = calls_.terminal_of(signature.first);
        if (terminal < 0 || symbols_.looks[terminal].empty()) return {};
        const std::string call = terminal_call(terminal, shape.style, shape);
        return call.empty() ? "" : "  else { " + call + " [] }\n";
    }

    /// Productions from `first` on, all of them with weights: one is drawn among those that hold.
    std::string weighted_text(const Signature& signature, const Scope& shape, std::size_t first, bool chained) {
        const std::vector<const Production*>& productions = calls_.productions_of(signature);
        std::string any, total, body;
        const std::string pick = symbols_.names.take("pick");
        for (std::size_t i = first; i < productions.size(); ++i) {
            const Production& production = *productions[i];
            if (!production.weight) throw NotByRules();
            const Scope scope = symbols_.scope_of(production, shape);
            const std::string holds =
                production.condition ? as_condition(text_of(*production.condition, scope)) : std::string("1 == 1");
            const std::string weight = as_number(text_of(*production.weight, scope)).text;
            any += (any.empty() ? "(" : " || (") + holds + ')';
            total += (total.empty() ? "" : " + ") + std::string("if(") + holds + ", " + weight + ", 0)";
            body += std::string(body.empty() ? "    " : "    else ") + "if ((" + holds + ") && " + pick + " < " + total +
                    ") {\n" + calls_text(production.successor, scope, "      ") + "    }\n";
        }
        return std::string(chained ? "  else " : "  ") + "if (" + any + ") {\n    " + pick + " = rand(0, " + total + ")\n" +
               body + "  }\n" + own_drawing(signature, shape);
    }
};

}  // namespace

std::optional<std::string> cfdg_rules(const Grammar& grammar, const DeriveOptions& limits, bool live_random,
                                      NoteList& notes) {
    DeriveOptions whole = limits;
    whole.depth = -1;
    const std::optional<Grammar> moved = inlined_moves(grammar);
    if (!moved) return std::nullopt;
    try {
        return RulesWriter(*moved, whole, live_random, notes).write();
    } catch (const NotByRules&) {
        return std::nullopt;
    }
}

}  // namespace rinceau
