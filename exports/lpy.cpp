#include "exports/lpy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "exports/drawn_terminal.h"
#include "exports/lpy_shapes.h"
#include "exports/prepared_grammar.h"
#include "exports/python_syntax.h"
#include "exports/target_names.h"
#include "lsystem/number_text.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

/// Names of modules that L-Py knows, and words of its files.
constexpr std::array lpy_names{"None",
                               "SB",
                               "EB",
                               "F",
                               "f",
                               "nF",
                               "X",
                               "MouseIns",
                               "Cut",
                               "any",
                               "x",
                               "repexp",
                               "all",
                               "or",
                               "GetPos",
                               "GetHead",
                               "GetUp",
                               "GetLeft",
                               "GetRight",
                               "GetFrame",
                               "StartGC",
                               "EndGC",
                               "BP",
                               "EP",
                               "PP",
                               "MoveTo",
                               "MoveRel",
                               "LineTo",
                               "OLineTo",
                               "Pinpoint",
                               "LineRel",
                               "OLineRel",
                               "PinpointRel",
                               "SetHead",
                               "EulerAngles",
                               "Left",
                               "Right",
                               "Up",
                               "Down",
                               "RollL",
                               "RollR",
                               "iRollL",
                               "iRollR",
                               "TurnAround",
                               "RollToVert",
                               "RollToHorizontal",
                               "Sphere",
                               "Box",
                               "Quad",
                               "Circle",
                               "Label",
                               "IncWidth",
                               "_",
                               "DecWidth",
                               "SetWidth",
                               "IncColor",
                               "DecColor",
                               "SetColor",
                               "InterpolateColors",
                               "TextureBaseColor",
                               "InterpolateTextureBaseColors",
                               "DivScale",
                               "MultScale",
                               "SetScale",
                               "surface",
                               "PglShape",
                               "Frame",
                               "Arrow",
                               "Elasticity",
                               "Tropism",
                               "SetContour",
                               "SectionResolution",
                               "SetGuide",
                               "EndGuide",
                               "Sweep",
                               "PositionOnGuide",
                               "TextureScale",
                               "TextureUScale",
                               "TextureVScale",
                               "TextureVCoeff",
                               "TextureTranslation",
                               "TextureRotation",
                               "TextureTransformation",
                               "LeftReflection",
                               "UpReflection",
                               "HeadingReflection",
                               "StartScreenProjection",
                               "EndScreenProjection",
                               "GetIterator",
                               "GetModule",
                               "new",
                               "newmodule",
                               "Axiom",
                               "Start",
                               "End",
                               "StartEach",
                               "EndEach",
                               "PostDraw",
                               "production",
                               "homomorphism",
                               "decomposition",
                               "interpretation",
                               "derivation",
                               "maximum",
                               "consider",
                               "ignore",
                               "group",
                               "endgroup",
                               "endlsystem",
                               "module",
                               "extern",
                               "undef",
                               "context",
                               "initconfig"};

bool is_lpy_name(std::string_view name) { return std::ranges::find(lpy_names, name) != lpy_names.end(); }

/// A rewriting rule's own names.
using Locals = std::map<std::string, std::string, std::less<>>;

class LpyWriter {
  public:
    LpyWriter(const PreparedGrammar& prepared, const ExportOptions& options)
        : prepared_(prepared), grammar_(prepared.grammar), options_(options) {
        name_everything();
    }

    Export write() {
        const std::string constants = constants_text();
        const std::string shapes = shapes_text();
        const std::string rules = rules_text();
        return {.bytes = head_text() + python_prelude(used_) + shapes + constants + modules_text() + rules,
                .notes = prepared_.notes};
    }

  private:
    const PreparedGrammar& prepared_;
    const Grammar& grammar_;
    const ExportOptions& options_;
    std::map<std::string, std::string, std::less<>> symbols_;
    std::map<std::string, std::string, std::less<>> constants_;
    std::set<std::string> python_names_;
    std::set<std::string> used_;
    struct StyledShape {
        int number;  ///< of the style in force, 0 = the terminal's own
        LpyShape shape;
    };
    std::vector<std::vector<StyledShape>> shapes_;  ///< per terminal

    void name_everything() {
        std::set<std::string> taken;
        const auto allowed = [](std::string_view name) { return !is_lpy_name(name) && !is_python_name_taken(name); };
        for (const std::string& symbol : all_symbols(grammar_)) symbols_[symbol] = free_name(symbol, taken, allowed);
        const auto python_allowed = [&](std::string_view name) {
            return !is_python_name_taken(name) && !name.starts_with("rinceau") && !name.starts_with("shape_");
        };
        for (const Constant& constant : grammar_.constants)
            constants_[constant.name] = free_name(constant.name, python_names_, python_allowed);
    }

    std::string symbol(const std::string& name) const { return symbols_.find(name)->second; }

    Locals locals_of(const std::vector<std::string>& parameters) const {
        Locals locals;
        std::set<std::string> taken;
        for (const std::string& parameter : parameters)
            locals[parameter] = free_name(parameter, taken, [](std::string_view name) {
                return !is_python_name_taken(name) && !name.starts_with("rinceau");
            });
        return locals;
    }

    std::string expression(const Expression& source, const Locals& locals) {
        ExpressionSyntax syntax = python_syntax(used_);
        syntax.name = [&](std::string_view name) -> std::optional<std::string> {
            if (const auto local = locals.find(name); local != locals.end()) return local->second;
            if (const auto constant = constants_.find(name); constant != constants_.end()) return constant->second;
            return std::nullopt;
        };
        std::optional<std::string> text = write_expression(source, syntax);
        if (!text) throw RulesLost{"L-Py has no counterpart of " + to_text(source)};
        return std::move(*text);
    }

    std::string head_text() const {
        std::string text = "# " + one_line(grammar_.title.empty() ? options_.name : grammar_.title) + '\n';
        text +=
            "# Written by Rinceau. Open it in L-Py (https://lpy.readthedocs.io) and run it; without a window:\n"
            "#   from openalea.lpy import Lsystem\n"
            "#   l = Lsystem('FILE.lpy'); s = l.sceneInterpretation(l.derive()); s.save('out.ply')\n"
            "# The turtle starts at the origin and heads +Z in the plane Y-Z: look along -X. + turns left, @Di multiplies "
            "the\n"
            "# scale, /(180) mirrors what follows about the heading.\n";
        for (const std::string& comment : grammar_.comments) text += "# " + one_line(comment) + '\n';
        std::string renamed;
        for (const auto& [name, given] : symbols_) {
            if (name != given) renamed += "#   " + name + " is " + given + '\n';
        }
        if (!renamed.empty()) text += "# Symbols that have another name here:\n" + renamed;
        return text;
    }

    std::string constants_text() {
        std::string text;
        for (const Constant& constant : grammar_.constants)
            text +=
                comment_text(constant.comment) + constants_[constant.name] + " = " + expression(constant.value, {}) + '\n';
        return text.empty() ? text : '\n' + text;
    }

    std::string shapes_text() {
        std::string text;
        for (const Terminal& terminal : grammar_.terminals) {
            std::vector<StyledShape>& shapes = shapes_.emplace_back();
            for (const StyleChoice& choice : styles_of(prepared_, terminal)) {
                std::string name = "shape_" + symbol(terminal.symbol);
                if (choice.number != 0) name += '_' + std::to_string(choice.number);
                shapes.push_back({choice.number, lpy_shape(terminal, choice.style, name)});
                text += shapes.back().shape.definition;
            }
        }
        return text.empty() ? text : '\n' + std::string(lpy_shapes_prelude) + text;
    }

    std::string modules_text() const {
        std::string names;
        for (const auto& [name, given] : symbols_) {
            if (given.size() > 1) names += (names.empty() ? "" : ", ") + given;
        }
        return names.empty() ? "\n" : "\nmodule " + names + '\n';
    }

    static std::string comment_text(const std::string& comment, const std::string& margin = "") {
        std::string text;
        for (std::size_t at = 0; at < comment.size();) {
            const std::size_t end = std::min(comment.find('\n', at), comment.size());
            text += margin + "# " + one_line(std::string_view(comment).substr(at, end - at)) + '\n';
            at = end + 1;
        }
        return text;
    }

    std::string module_text(const ModuleTemplate& module, const Locals& locals) {
        std::string arguments;
        for (const Expression& argument : module.arguments)
            arguments += (arguments.empty() ? "" : ", ") + expression(argument, locals);
        const TurtleCommandInfo* command = find_turtle_command(module.symbol);
        if (command == nullptr) return symbol(module.symbol) + (arguments.empty() ? "" : '(' + arguments + ')');
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

    std::string string_text(const std::vector<ModuleTemplate>& modules, const Locals& locals) {
        std::string text;
        for (const ModuleTemplate& module : modules) {
            const std::string part = module_text(module, locals);
            if (!part.empty()) text += (text.empty() ? "" : " ") + part;
        }
        return text.empty() ? std::string(lpy_nothing) : text;
    }

    std::string context_text(const std::vector<ContextModule>& context, Locals& locals) const {
        std::string text;
        for (const ContextModule& module : context) {
            std::string parameters;
            for (const std::string& parameter : module.parameters)
                parameters += (parameters.empty() ? "" : ", ") + locals.find(parameter)->second;
            text += (text.empty() ? "" : " ") + symbol(module.symbol) + (parameters.empty() ? "" : '(' + parameters + ')');
        }
        return text;
    }

    /// One production, or none of whose parameters fit the ones before: a rule of its own.
    std::string rule_text(const std::vector<const Production*>& productions) {
        const Production& first = *productions.front();
        std::vector<std::string> all = first.parameters;
        for (const auto* context : {&first.left_context, &first.right_context}) {
            for (const ContextModule& module : *context)
                all.insert(all.end(), module.parameters.begin(), module.parameters.end());
        }
        Locals locals = locals_of(all);
        std::string parameters;
        for (const std::string& parameter : first.parameters)
            parameters += (parameters.empty() ? "" : ", ") + locals[parameter];
        std::string head = symbol(first.symbol) + (parameters.empty() ? "" : '(' + parameters + ')');
        if (!first.left_context.empty()) head = context_text(first.left_context, locals) + " < " + head;
        if (!first.right_context.empty()) head += " > " + context_text(first.right_context, locals);
        std::string body;
        for (const Production* production : productions) {
            Locals own = locals;
            for (std::size_t i = 0; i < production->parameters.size(); ++i)
                own[production->parameters[i]] = locals[first.parameters[i]];
            const std::string successor = "produce " + string_text(production->successor, own) + '\n';
            body += comment_text(production->comment, "    ");
            const bool begins = production == productions.front();
            if (production->condition) {
                body +=
                    (begins ? "    if " : "    elif ") + expression(*production->condition, own) + ":\n        " + successor;
            } else {
                body += begins ? "    " + successor : "    else:\n        " + successor;
                break;
            }
        }
        return head + ":\n" + body;
    }

    /// The rules of one kind; those of one symbol that differ in their conditions only are one rule in L-Py.
    std::string rules_of(ProductionKind kind) {
        const auto is_plain = [](const Production& p) { return p.left_context.empty() && p.right_context.empty(); };
        std::vector<bool> written(grammar_.productions.size(), false);
        std::string text;
        for (std::size_t i = 0; i < grammar_.productions.size(); ++i) {
            const Production& first = grammar_.productions[i];
            if (first.kind != kind || written[i]) continue;
            std::vector<const Production*> together{&first};
            for (std::size_t k = i + 1; is_plain(first) && k < grammar_.productions.size(); ++k) {
                const Production& next = grammar_.productions[k];
                if (next.kind != kind || next.symbol != first.symbol || next.parameters.size() != first.parameters.size())
                    continue;
                if (!is_plain(next)) break;
                together.push_back(&next);
                written[k] = true;
            }
            text += rule_text(together);
        }
        return text;
    }

    std::string drawing_rules() const {
        std::string text;
        for (std::size_t i = 0; i < grammar_.terminals.size(); ++i) {
            for (const std::size_t arity : arities_of(grammar_, grammar_.terminals[i].symbol))
                text += drawing_rule(grammar_.terminals[i], shapes_[i], arity);
        }
        return text;
    }

    std::string drawing_rule(const Terminal& terminal, const std::vector<StyledShape>& shapes, std::size_t arity) const {
        std::string parameters;
        for (std::size_t i = 0; i < arity; ++i) {
            const bool is_style = prepared_.styled && i + 1 == arity;
            parameters += (parameters.empty() ? "" : ", ") + (is_style ? "style" : 'a' + std::to_string(i));
        }
        std::string text = comment_text(terminal.comment) + symbol(terminal.symbol) +
                           (parameters.empty() ? "" : '(' + parameters + ')') + ":\n";
        if (shapes.size() == 1) return text + "    produce " + shapes.front().shape.drawing + '\n';
        for (const StyledShape& shape : shapes) {
            text += shape.number == shapes.front().number ? "    if" : "    elif";
            text += " style == " + std::to_string(shape.number) + ":\n        produce " + shape.shape.drawing + '\n';
        }
        return text;
    }

    std::string rules_text() {
        const bool contexts = has_contexts(grammar_);
        const std::string limit = "maximum depth: " + std::to_string(DeriveOptions{}.max_recursion) + '\n';
        std::string text = "\nAxiom: " + string_text(grammar_.axiom, {}) + '\n';
        const int steps = contexts ? steps_to_the_end(grammar_, options_.derive) : 1;
        if (contexts) {
            std::string ignored = "+ - f @Di /";
            for (const std::string& name : grammar_.ignored) {
                if (symbols_.contains(name)) ignored += ' ' + symbol(name);
            }
            text += "ignore: " + ignored + '\n';
        }
        text += "derivation length: " + std::to_string(steps) + "\nproduction:\n";
        if (contexts) text += rules_of(ProductionKind::rewriting);
        const std::string decompositions =
            rules_of(ProductionKind::decomposition) + (contexts ? "" : rules_of(ProductionKind::rewriting));
        if (!decompositions.empty()) text += "decomposition:\n" + limit + decompositions;
        const std::string homomorphisms = rules_of(ProductionKind::homomorphism);
        const std::string drawings = drawing_rules();
        if (!homomorphisms.empty() || !drawings.empty())
            text += "interpretation:\n" + (homomorphisms.empty() ? "" : limit) + homomorphisms + drawings;
        return text + "endlsystem\n";
    }
};

}  // namespace

Export to_lpy(const Grammar& grammar, const ExportOptions& options) {
    return write_prepared(grammar, options, "L-Py",
                          [&](const PreparedGrammar& prepared) { return LpyWriter(prepared, options).write(); });
}

}  // namespace rinceau
