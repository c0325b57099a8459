#include "lsystem/grammar_text.h"

#include <array>

#include "lsystem/number_text.h"
#include "lsystem/parse_production.h"
#include "lsystem/parse_text.h"
#include "lsystem/statement.h"
#include "lsystem/style_text.h"
#include "scene/svg_write.h"

namespace rinceau {

Grammar parse_grammar(std::string_view text, const std::string& file_name) {
    ParseState state = parse_text(text, file_name);
    if (state.mistakes.empty()) return std::move(state.grammar);
    throw InputError(state.mistakes.front().place, state.mistakes.front().message);
}

namespace {

constexpr std::size_t line_width = 110;

std::string module_text(const ModuleTemplate& module) {
    std::string text = module.symbol;
    for (std::size_t i = 0; i < module.arguments.size(); ++i) {
        text += i == 0 ? "(" : ", ";
        text += to_text(module.arguments[i]);
    }
    return module.arguments.empty() ? text : text + ')';
}

/// "[A] f(13) P1(m-1)": brackets close to what they hold; long strings go on in indented lines.
std::string modules_text(const std::vector<ModuleTemplate>& modules, std::size_t column) {
    std::string text;
    for (std::size_t i = 0; i < modules.size(); ++i) {
        const std::string module = module_text(modules[i]);
        const bool close = i > 0 && (modules[i - 1].symbol == "[" || modules[i].symbol == "]");
        if (!close) {
            const bool full = i > 0 && column + 1 + module.size() > line_width;
            text += full ? "\n  " : " ";
            column = full ? 2 : column + 1;
        }
        text += module;
        column += module.size();
    }
    return text;
}

/// Path data in lines that end before a command.
std::string wrapped_path(const std::string& data) {
    std::string text;
    std::size_t column = 0;
    for (std::size_t i = 0; i < data.size(); ++i) {
        if (column > line_width && std::string_view("MLHVCZ").find(data[i]) != std::string_view::npos) {
            text += "\n  ";
            column = 2;
        }
        text += data[i];
        ++column;
    }
    return text;
}

std::string canvas_text(const Grammar& grammar) {
    const Box& box = grammar.canvas;
    const std::string ending = grammar.sized ? "\n" : " unsized\n";
    if (is_empty(box)) return grammar.sized ? "" : "canvas none unsized\n";
    const double top = -box.high.y;
    const double bottom = -box.low.y;
    const double across = box.high.x - box.low.x;
    const double down = bottom - top;
    // a width says more than a right edge, but must give the same edge again
    const bool exact = box.low.x + across == box.high.x && top + down == bottom;
    std::string text = exact ? "canvas" : "canvas corners";
    for (const double number : {box.low.x, top, exact ? across : box.high.x, exact ? down : bottom}) {
        text += ' ';
        text += number_text(number);
    }
    return text + ending;
}

std::string predecessor_text(const std::string& symbol, const std::vector<std::string>& parameters) {
    std::string text = symbol;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        text += i == 0 ? "(" : ", ";
        text += parameters[i];
    }
    return parameters.empty() ? text : text + ')';
}

std::string context_text(const std::vector<ContextModule>& context) {
    std::string text;
    for (const ContextModule& module : context) text += predecessor_text(module.symbol, module.parameters) + ' ';
    return text;
}

std::string kind_text(ProductionKind kind) {
    if (kind == ProductionKind::rewriting) return {};
    return std::string(kind == ProductionKind::decomposition ? decomposition_word : homomorphism_word) + ' ';
}

std::string production_text(const Production& production) {
    std::string text = kind_text(production.kind);
    if (!production.left_context.empty()) text += context_text(production.left_context) + "< ";
    text += predecessor_text(production.symbol, production.parameters) + ' ';
    if (!production.right_context.empty()) text += "> " + context_text(production.right_context);
    if (production.condition) text += ": " + to_text(*production.condition) + ' ';
    text += "->";
    text += modules_text(production.successor, text.size());
    if (production.weight) text += " : " + to_text(*production.weight);
    return text + '\n';
}

std::string use_text(const Use& use) {
    return "use " + in_quotes(use.file) + (use.prefix.empty() ? "" : " as " + use.prefix) + '\n';
}

std::string ignore_text(const std::vector<std::string>& symbols) {
    if (symbols.empty()) return {};
    std::string text = "ignore";
    for (const std::string& symbol : symbols) text += ' ' + symbol;
    return text + '\n';
}

std::string exception_text(const Exception& exception) {
    std::string text = "except ";
    for (std::size_t i = 0; i < exception.address.size(); ++i) {
        if (i > 0) text += '.';
        text += std::to_string(exception.address[i]);
    }
    text += " ->";
    return text + modules_text(exception.successor, text.size()) + '\n';
}

/// A name that is no line of the fragment.
std::string fragment_tag(const std::string& fragment) {
    const std::string lines = '\n' + fragment + '\n';
    const auto taken = [&](const std::string& tag) {
        return lines.find('\n' + tag + '\n') != std::string::npos || lines.find('\n' + tag + "\r\n") != std::string::npos;
    };
    std::string tag = "SVG";
    for (int number = 1; taken(tag); ++number) tag = "SVG" + std::to_string(number);
    return tag;
}

std::string verbatim_text(const Terminal& terminal) {
    const std::string tag = fragment_tag(terminal.verbatim);
    return "verbatim <<<" + tag + '\n' + terminal.verbatim + '\n' + tag;
}

std::string terminal_text(const Terminal& terminal) {
    std::vector<std::string> parts;
    if (terminal.style != 0) parts.push_back("style " + std::to_string(terminal.style));
    if (!terminal.paths.empty()) parts.push_back("path \"" + wrapped_path(svg_path_data(terminal.paths)) + '"');
    if (!terminal.id.empty()) parts.push_back("id " + in_quotes(terminal.id));
    if (!is_empty(terminal.verbatim_box)) {
        const Box& box = terminal.verbatim_box;
        parts.push_back("box " + number_text(box.low.x) + ' ' + number_text(-box.high.y) + ' ' + number_text(box.high.x) +
                        ' ' + number_text(-box.low.y));
    }
    if (!terminal.verbatim.empty()) parts.push_back(verbatim_text(terminal));
    std::string text = "terminal " + terminal.symbol + ':';
    for (std::size_t i = 0; i < parts.size(); ++i) {
        text += i > 0 ? "; " : " ";
        text += parts[i];
    }
    return text + '\n';
}

/// Sections are set apart by an empty line.
void append_section(std::string& text, const std::string& section) {
    if (section.empty()) return;
    text += '\n';
    text += section;
}

}  // namespace

namespace {

/// Line ends and the indentation behind them become one blank. No statement of modules holds quoted text.
std::string in_one_line(const std::string& statement) {
    std::string text;
    for (const char c : statement) {
        const bool blank = is_blank(c);
        if (!blank || (!text.empty() && text.back() != ' ')) text += blank ? ' ' : c;
    }
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text;
}

}  // namespace

std::string statement_text(const Production& production) { return in_one_line(production_text(production)); }

std::string statement_text(const Exception& exception) { return in_one_line(exception_text(exception)); }

std::string axiom_text(const Grammar& grammar) {
    constexpr std::string_view axiom = "axiom:";
    return in_one_line(std::string(axiom) + modules_text(grammar.axiom, axiom.size()));
}

std::string to_text(const Grammar& grammar) {
    std::string text = "lsystem 1\n";
    if (!grammar.title.empty()) text += "title " + in_quotes(grammar.title) + '\n';
    std::string comments;
    for (const std::string& line : grammar.comments) comments += comment_line(line);
    append_section(text, comments);
    append_section(text, canvas_text(grammar));
    if (grammar.seed) append_section(text, "seed " + std::to_string(*grammar.seed) + '\n');
    std::string section;
    for (const Use& use : grammar.uses) section += commented(use.comment) + use_text(use);
    append_section(text, section);
    section.clear();
    for (const Constant& constant : grammar.constants) {
        section += commented(constant.comment) + "define " + constant.name + " = " + to_text(constant.value) + '\n';
    }
    append_section(text, section);
    constexpr std::string_view axiom = "axiom:";
    if (!grammar.axiom.empty()) append_section(text, std::string(axiom) + modules_text(grammar.axiom, axiom.size()) + '\n');
    append_section(text, ignore_text(grammar.ignored));
    section.clear();
    for (const Production& production : grammar.productions)
        section += commented(production.comment) + production_text(production);
    append_section(text, section);
    section.clear();
    for (const Exception& exception : grammar.exceptions)
        section += commented(exception.comment) + exception_text(exception);
    append_section(text, section);
    section.clear();
    for (const NumberedStyle& style : grammar.styles) {
        section +=
            commented(style.comment) + "style " + std::to_string(style.number) + ": " + style_text(style.style) + '\n';
    }
    append_section(text, section);
    section.clear();
    for (const Terminal& terminal : grammar.terminals) section += commented(terminal.comment) + terminal_text(terminal);
    append_section(text, section);
    return text;
}

}  // namespace rinceau
