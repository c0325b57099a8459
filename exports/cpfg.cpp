#include "exports/cpfg.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "exports/cpfg_syntax.h"
#include "exports/drawn_terminal.h"
#include "exports/palette.h"
#include "exports/prepared_grammar.h"
#include "exports/single_characters.h"
#include "exports/target_names.h"
#include "exports/turtle_walk.h"
#include "lsystem/number_text.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

/// Characters that cpfg's turtle gives no meaning; D and i are parts of @Di.
constexpr std::string_view free_characters = "ABCEHIJKLMNOPQRSTUVWXYZabcdehjklmnopqrstuvwxyz";
constexpr std::size_t longest_line = 110;
/// cpfg's parser counts the numbers of a file in a name of 30 characters, 127 to a character.
constexpr std::size_t most_numbers = 3500;

using Names = std::map<std::string, std::string, std::less<>>;

/// A comment's text: cpfg's scanner stops at a slash, and its files are ASCII.
std::string comment_line(std::string_view text) {
    std::string line = one_line(text);
    for (char& c : line) {
        if (c == '/') c = '|';
        if (static_cast<unsigned char>(c) >= 128) c = '?';
    }
    return "/* " + line + " */\n";
}

std::string comment_lines(const std::string& comment) {
    std::string text;
    for (std::size_t at = 0; at < comment.size();) {
        const std::size_t end = std::min(comment.find('\n', at), comment.size());
        text += comment_line(std::string_view(comment).substr(at, end - at));
        at = end + 1;
    }
    return text;
}

std::string turn_text(double turn) { return turn == 0 ? "" : (turn < 0 ? "-(" : "+(") + cpfg_number(std::abs(turn)) + ')'; }

/// Long strings go on in lines that begin with a tab.
class StringText {
  public:
    void add(const std::string& module) {
        if (line_ + module.size() > longest_line) {
            text_ += "\n\t";
            line_ = 0;
        }
        text_ += module;
        line_ += module.size();
    }
    std::string take() { return std::move(text_); }

  private:
    std::string text_;
    std::size_t line_ = 0;
};

class CpfgWriter {
  public:
    CpfgWriter(const PreparedGrammar& prepared, const ExportOptions& options)
        : prepared_(prepared),
          grammar_(prepared.grammar),
          options_(options),
          symbols_(single_characters(all_symbols(prepared.grammar), free_characters)) {
        name_constants();
    }

    Export write() {
        const std::string constants = constants_text();
        const std::string rules = rules_text();
        Export result{.bytes = head_text() + cpfg_prelude(used_) + constants + rules, .notes = prepared_.notes};
        result.companions = {{".v", view_text()}, {".map", map_bytes()}};
        add_notes(result);
        return result;
    }

  private:
    const PreparedGrammar& prepared_;
    const Grammar& grammar_;
    const ExportOptions& options_;
    std::map<std::string, SingleCharacter, std::less<>> symbols_;
    Names constants_;
    std::set<std::string> used_;
    Palette palette_{1, 255};  // 0 is the background

    /// Names begin with a letter.
    static std::string lettered(const std::string& name) { return name.front() == '_' ? 'p' + name : name; }

    void name_constants() {
        std::set<std::string> taken{"k_degree", "k_radian"};
        for (const Constant& constant : grammar_.constants)
            constants_[constant.name] = free_name("k_" + constant.name, taken, [](std::string_view) { return true; });
    }

    static Names locals_of(const std::vector<std::string>& parameters) {
        Names locals;
        std::set<std::string> taken;
        for (const std::string& parameter : parameters)
            locals[parameter] = free_name(lettered(parameter), taken, [](std::string_view name) {
                return !is_cpfg_name_taken(name) && !name.starts_with("k_");
            });
        return locals;
    }

    std::string expression(const Expression& source, const Names& locals) {
        ExpressionSyntax syntax = cpfg_syntax(used_);
        syntax.name = [&](std::string_view name) -> std::optional<std::string> {
            if (const auto local = locals.find(name); local != locals.end()) return local->second;
            if (const auto constant = constants_.find(name); constant != constants_.end()) return constant->second;
            return std::nullopt;
        };
        std::optional<std::string> text = write_expression(source, syntax);
        if (!text) throw RulesLost{"cpfg has no counterpart of " + to_text(source)};
        return std::move(*text);
    }

    std::string head_text() const {
        std::string text = comment_line(grammar_.title.empty() ? options_.name : grammar_.title);
        text += comment_line("Written by Rinceau. Open it with the Virtual Laboratory's cpfg (algorithmicbotany.org):");
        text += comment_line("  cpfg -m FILE.map FILE.l FILE.v");
        for (const std::string& comment : grammar_.comments) text += comment_line(comment);
        text += comment_line("Symbols:");
        for (const auto& [name, symbol] : symbols_) {
            const std::string number = symbol.number < 0 ? "" : '(' + std::to_string(symbol.number) + ",..)";
            text += comment_line("  " + std::string(1, symbol.character) + number + " is " + name);
        }
        return text;
    }

    std::string constants_text() {
        std::string text;
        for (const Constant& constant : grammar_.constants)
            text += comment_lines(constant.comment) + "#define " + constants_[constant.name] + " (" +
                    expression(constant.value, {}) + ")\n";
        return text;
    }

    std::string symbol_text(const std::string& name, std::string arguments) const {
        const SingleCharacter& symbol = symbols_.find(name)->second;
        if (symbol.number >= 0) arguments = std::to_string(symbol.number) + (arguments.empty() ? "" : ',' + arguments);
        return symbol.character + (arguments.empty() ? std::string() : '(' + arguments + ')');
    }

    std::string module_text(const ModuleTemplate& module, const Names& locals) {
        std::string arguments;
        for (const Expression& argument : module.arguments)
            arguments += (arguments.empty() ? "" : ",") + expression(argument, locals);
        const TurtleCommandInfo* command = find_turtle_command(module.symbol);
        if (command == nullptr) return symbol_text(module.symbol, arguments);
        switch (command->command) {
            case TurtleCommand::scale:
                return "@Di(" + arguments + ')';
            case TurtleCommand::mirror:
                return "/(180)";
            case TurtleCommand::layer:
                return {};
            case TurtleCommand::push:
            case TurtleCommand::pop:
                return module.symbol;
            default:
                return module.symbol + '(' + arguments + ')';
        }
    }

    std::string string_text(const std::vector<ModuleTemplate>& modules, const Names& locals) {
        StringText text;
        for (const ModuleTemplate& module : modules) text.add(module_text(module, locals));
        std::string whole = text.take();
        return whole.empty() ? "*" : whole;
    }

    /// symbol(parameters) as a pattern; modules that share a character are told apart by `conditions`.
    std::string pattern_text(const std::string& name, const std::vector<std::string>& parameters, const Names& locals,
                             std::vector<std::string>& conditions) const {
        std::string names;
        const SingleCharacter& symbol = symbols_.find(name)->second;
        if (symbol.number >= 0) {
            names = "k_which" + std::to_string(conditions.size());
            conditions.push_back(names + " == " + std::to_string(symbol.number));
        }
        for (const std::string& parameter : parameters) names += (names.empty() ? "" : ",") + locals.find(parameter)->second;
        return symbol.character + (names.empty() ? std::string() : '(' + names + ')');
    }

    static std::string condition_text(const std::vector<std::string>& conditions) {
        std::string text;
        for (const std::string& condition : conditions)
            text += (text.empty() ? "" : " && ") + (conditions.size() > 1 ? '(' + condition + ')' : condition);
        return text.empty() ? "" : " : " + text;
    }

    std::string rule_text(const Production& production) {
        std::vector<std::string> all = production.parameters;
        for (const auto* context : {&production.left_context, &production.right_context}) {
            for (const ContextModule& module : *context)
                all.insert(all.end(), module.parameters.begin(), module.parameters.end());
        }
        const Names locals = locals_of(all);
        std::vector<std::string> conditions;
        std::string left;
        std::string right;
        for (const ContextModule& module : production.left_context)
            left += pattern_text(module.symbol, module.parameters, locals, conditions);
        for (const ContextModule& module : production.right_context)
            right += pattern_text(module.symbol, module.parameters, locals, conditions);
        const std::string strict = pattern_text(production.symbol, production.parameters, locals, conditions);
        if (production.condition) conditions.push_back(expression(*production.condition, locals));
        return comment_lines(production.comment) + (left.empty() ? "" : left + " < ") + strict +
               (right.empty() ? "" : " > " + right) + condition_text(conditions) + " --> " +
               string_text(production.successor, locals) + '\n';
    }

    std::string rules_of(ProductionKind kind) {
        std::string text;
        for (const Production& production : grammar_.productions) {
            if (production.kind == kind) text += rule_text(production);
        }
        return text;
    }

    std::string color_text(Color color) { return ";(" + std::to_string(palette_.number_of(color)) + ')'; }

    /// Steps as modules, the first without drawing.
    static void add_walk(StringText& text, const std::vector<Point>& corners, const std::string& begin,
                         const std::string& draw) {
        const std::vector<WalkStep> steps = walk_along(corners);
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const std::string go = i == 0 ? "f" : draw;
            text.add(turn_text(steps[i].turn) + (steps[i].length > 0 ? go + '(' + cpfg_number(steps[i].length) + ')' : "") +
                     (i == 0 ? begin : ""));
        }
    }

    std::string drawing_text(const DrawnTerminal& drawn, double deviation) {
        StringText text;
        const auto fill = [&] {
            for (const Polygon& polygon : drawn.polygons) {
                text.add('[' + color_text(*drawn.fill));
                add_walk(text, polygon, "{.", "f");
                text.add("}]");
            }
        };
        const auto line = [&] {
            for (const Path& path : drawn.outlines) {
                text.add('[' + color_text(*drawn.line) + "#(" + cpfg_number(drawn.width) + ')');
                add_walk(text, polyline_of(path, deviation), "", "F");
                text.add("]");
            }
        };
        if (drawn.line_first && drawn.line) line();
        if (drawn.fill) fill();
        if (!drawn.line_first && drawn.line) line();
        std::string whole = text.take();
        return whole.empty() ? "*" : whole;
    }

    std::string drawing_rules() {
        std::string text;
        for (const Terminal& terminal : grammar_.terminals) {
            for (const StyleChoice& choice : styles_of(prepared_, terminal)) {
                const double deviation = flatness_share * std::max(outline_size(terminal), 1e-300);
                const std::string drawing = drawing_text(drawn_terminal(terminal, choice.style), deviation);
                for (const std::size_t arity : arities_of(grammar_, terminal.symbol))
                    text += drawing_rule(terminal, choice, arity, drawing);
            }
        }
        return text;
    }

    std::string drawing_rule(const Terminal& terminal, const StyleChoice& choice, std::size_t arity,
                             const std::string& drawing) const {
        std::vector<std::string> parameters;
        for (std::size_t i = 0; i < arity; ++i) parameters.push_back("a" + std::to_string(i));
        const Names locals = locals_of(parameters);
        std::vector<std::string> conditions;
        const std::string pattern = pattern_text(terminal.symbol, parameters, locals, conditions);
        if (prepared_.styled) conditions.push_back(parameters.back() + " == " + std::to_string(choice.number));
        return (choice.number == 0 ? comment_lines(terminal.comment) : "") + pattern + condition_text(conditions) + " --> " +
               drawing + '\n';
    }

    std::string rules_text() {
        const bool contexts = has_contexts(grammar_);
        const std::string limit = "maximum depth: " + std::to_string(DeriveOptions{}.max_recursion) + '\n';
        std::string text = "lsystem: 1\n";
        if (contexts) {
            text += "ignore: +-f@Di/";
            for (const std::string& name : grammar_.ignored) {
                if (const auto symbol = symbols_.find(name); symbol != symbols_.end()) text += symbol->second.character;
            }
            text += '\n';
        }
        const int steps = contexts ? steps_to_the_end(grammar_, options_.derive) : 1;
        text += "derivation length: " + std::to_string(steps) + "\naxiom: " + string_text(grammar_.axiom, {}) + "\n\n";
        if (contexts) text += rules_of(ProductionKind::rewriting);
        const std::string decompositions =
            rules_of(ProductionKind::decomposition) + (contexts ? "" : rules_of(ProductionKind::rewriting));
        if (!decompositions.empty()) text += "decomposition\n" + limit + decompositions;
        const std::string homomorphisms = rules_of(ProductionKind::homomorphism);
        const std::string drawings = drawing_rules();
        if (!homomorphisms.empty() || !drawings.empty())
            text += "homomorphism\n" + (homomorphisms.empty() ? "" : limit) + homomorphisms + drawings;
        return text + "endlsystem\n";
    }

    static std::string view_text() {
        return "angle increment: 90\n"
               "initial color: 1\n"
               "initial line width: 1\n"
               "initial scale: 1\n"
               "line style: polygon\n"
               "viewpoint: 0,0,1\n"
               "view reference point: 0,0,0\n"
               "twist: 0\n"
               "projection: parallel\n"
               "scale factor: 0.9\n"
               "z buffer: off\n";
    }

    /// 256 colours of three bytes; the background is white.
    std::string map_bytes() const {
        constexpr std::size_t colors = 256;
        std::vector<Color> map{{255, 255, 255}};
        map.insert(map.end(), palette_.colors().begin(), palette_.colors().end());
        map.resize(colors);
        std::string bytes;
        for (const Color color : map) {
            for (const std::uint8_t channel : {color.red, color.green, color.blue}) bytes += static_cast<char>(channel);
        }
        return bytes;
    }

    void add_notes(Export& result) const {
        if (palette_.overflowed()) result.notes.push_back("cpfg has 255 colours: the others are the nearest of them.");
        const auto fixed = [](const NumberedStyle& style) { return paints_stroke(style.style) && style.style.stroke.fixed; };
        if (std::ranges::any_of(grammar_.styles, fixed))
            result.notes.push_back("cpfg's lines follow the scale: strokes of fixed width do, too.");
        const auto numbers = static_cast<std::size_t>(std::ranges::count(result.bytes, '('));
        if (numbers > most_numbers) {
            result.notes.push_back("cpfg's parser may fail beyond " + std::to_string(most_numbers) +
                                   " numbers in a file; this one has some " + std::to_string(numbers) + '.');
        }
    }
};

}  // namespace

Export to_cpfg(const Grammar& grammar, const ExportOptions& options) {
    return write_prepared(grammar, options, "cpfg",
                          [&](const PreparedGrammar& prepared) { return CpfgWriter(prepared, options).write(); });
}

}  // namespace rinceau
