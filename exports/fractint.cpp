#include "exports/fractint.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "exports/colors_as_styles.h"
#include "exports/drawn_terminal.h"
#include "exports/palette.h"
#include "exports/plain_decimal.h"
#include "exports/repeated_parts.h"
#include "exports/target_names.h"
#include "exports/turtle_walk.h"
#include "lsystem/derive.h"
#include "lsystem/flat_grammar.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

/// Characters that are no commands; the last names the whole drawing. q is kept for a rule that nothing uses.
constexpr const char* free_characters = "abehijklnoprtuvwxyz\"#$%&'()*,:?^_`~s";
constexpr std::size_t longest_line = 120;
constexpr std::size_t longest_number = 26;  // Fractint's buffer has room for 29 characters
constexpr std::size_t most_modules = 300'000;
constexpr std::size_t dos_size = 60'000;

/// "@2.5" multiplies lengths by 2.5, "@i2.5" divides; what is too small to write is neither.
std::string scaled_by(double factor) {
    if (factor == 1) return {};
    constexpr double small = 1e-3;  // the inverse has more digits then
    return factor < small ? "@i" + plain_decimal(1 / factor, longest_number) : '@' + plain_decimal(factor, longest_number);
}

std::string scaled_back(double factor) {
    std::string text = scaled_by(factor);
    if (text.empty()) return text;
    return text[1] == 'i' ? '@' + text.substr(2) : "@i" + text.substr(1);
}

bool is_writable(double factor) {
    constexpr double least = 1e-20;
    return factor > least && factor < 1 / least;
}

std::string turned(double degrees) {
    const std::string number = plain_decimal(std::abs(degrees), longest_number);
    return number == "0" ? std::string() : (degrees > 0 ? '\\' : '/') + number;
}

std::string moved(double length) {
    if (!is_writable(std::abs(length))) return {};
    const std::string forward = scaled_by(std::abs(length)) + 'm' + scaled_back(std::abs(length));
    return length > 0 ? forward : "\\180" + forward + "/180";
}

class FractintWriter {
  public:
    FractintWriter(const Grammar& grammar, const ExportOptions& options) : grammar_(grammar), options_(options) {}

    Export write() {
        const ModuleString derived = derive(grammar_, options_.derive);
        if (derived.modules.size() > most_modules) {
            throw InputError({}, "expected a string of at most " + std::to_string(most_modules) +
                                     " modules, which Fractint has to be given one by one, found " +
                                     std::to_string(derived.modules.size()) + "; L-Py and cpfg take the rules");
        }
        read(derived);
        const std::vector<NamedPart> parts = named_parts(string_, free_characters);
        Export result{.bytes = entry_text(parts), .notes = drawing_notes(grammar_, "Fractint")};
        result.companions = {{".map", map_text()}};
        add_notes(result);
        return result;
    }

  private:
    struct State {
        int style = 0;
    };

    const Grammar& grammar_;
    const ExportOptions& options_;
    BracketedString string_;
    std::map<std::string, int> atom_numbers_;
    std::map<std::vector<int>, int> group_numbers_;
    std::map<std::pair<int, int>, int> shapes_;  ///< terminal, style -> atom
    Palette palette_{1, 255};                    // 0 is the background

    int atom(const std::string& text) {
        const auto [found, is_new] = atom_numbers_.try_emplace(text, static_cast<int>(string_.atoms.size()));
        if (is_new) string_.atoms.push_back(text);
        return found->second;
    }

    /// Groups are numbered from 0 while atoms are still added; renumbered at the end.
    static int group_token(int group) { return -1 - group; }

    void read(const ModuleString& derived) {
        std::vector<State> states{{}};
        std::vector<std::vector<int>> open{{}};
        for (const Module& module : derived.modules) {
            const std::string& symbol = derived.symbols[static_cast<std::size_t>(module.symbol)];
            if (symbol == "[") {
                states.push_back(State(states.back()));
                open.emplace_back();
            } else if (symbol == "]") {
                if (open.size() == 1) throw InputError({}, "expected '[' before each ']' of the derived string, found none");
                states.pop_back();
                close_group(open);
            } else if (symbol == ";") {
                states.back().style = static_cast<int>(module.arguments.front());
            } else {
                append(symbol, module.arguments.empty() ? 0 : module.arguments.front(), states.back(), open.back());
            }
        }
        while (open.size() > 1) close_group(open);
        string_.whole = std::move(open.front());
        const int atoms = static_cast<int>(string_.atoms.size());
        const auto renumber = [&](std::vector<int>& tokens) {
            for (int& token : tokens) token = token < 0 ? atoms - 1 - token : token;
        };
        renumber(string_.whole);
        for (std::vector<int>& group : string_.groups) renumber(group);
    }

    void close_group(std::vector<std::vector<int>>& open) {
        std::vector<int> content = std::move(open.back());
        open.pop_back();
        const auto [found, is_new] = group_numbers_.try_emplace(content, static_cast<int>(string_.groups.size()));
        if (is_new) string_.groups.push_back(std::move(content));
        if (!found->first.empty()) open.back().push_back(group_token(found->second));
    }

    void append(const std::string& symbol, double argument, const State& state, std::vector<int>& tokens) {
        const TurtleCommandInfo* command = find_turtle_command(symbol);
        if (command == nullptr) {
            append_shape(symbol, state, tokens);
            return;
        }
        const std::string text = command_text(command->command, argument);
        if (!text.empty()) tokens.push_back(atom(text));
    }

    static std::string command_text(TurtleCommand command, double argument) {
        switch (command) {
            case TurtleCommand::left:
                return turned(std::remainder(argument, 360.0));
            case TurtleCommand::right:
                return turned(-std::remainder(argument, 360.0));
            case TurtleCommand::forward:
                return moved(argument);
            case TurtleCommand::scale:
                return scaled_by(argument);
            case TurtleCommand::mirror:
                return "!";
            default:
                return {};
        }
    }

    void append_shape(const std::string& symbol, const State& state, std::vector<int>& tokens) {
        const auto terminal = std::ranges::find(grammar_.terminals, symbol, &Terminal::symbol);
        if (terminal == grammar_.terminals.end()) return;
        const auto [found, is_new] =
            shapes_.try_emplace({static_cast<int>(terminal - grammar_.terminals.begin()), state.style}, 0);
        if (is_new) {
            const int number = state.style != 0 ? state.style : terminal->style;
            const auto style = std::ranges::find(grammar_.styles, number, &NumberedStyle::number);
            found->second = atom(shape_text(*terminal, style == grammar_.styles.end() ? Style{} : style->style));
        }
        if (!string_.atoms[static_cast<std::size_t>(found->second)].empty()) tokens.push_back(found->second);
    }

    /// Strokes, or the outline of a fill without stroke.
    std::string shape_text(const Terminal& terminal, const Style& style) {
        const DrawnTerminal drawn = drawn_terminal(terminal, style);
        const std::optional<Color> color = drawn.line ? drawn.line : drawn.fill;
        std::string text;
        if (!color) return text;
        const double deviation = flatness_share * std::max(outline_size(terminal), 1e-300);
        for (Path path : terminal.paths) {
            if (!drawn.line) path.closed = true;
            if (!drawn.line && polyline_of(path, deviation).size() <= 3) continue;  // there and back: no area
            text += polyline_text(walk_along(polyline_of(path, deviation)), palette_.number_of(*color));
        }
        return text;
    }

    static std::string polyline_text(const std::vector<WalkStep>& steps, int color) {
        if (steps.size() < 2) return {};
        std::string text = "[c" + std::to_string(color) + turned(steps.front().turn) + moved(steps.front().length);
        double length = 1;
        for (std::size_t i = 1; i < steps.size(); ++i) {
            text += turned(steps[i].turn);
            if (!is_writable(steps[i].length)) continue;
            if (steps[i].length != length) text += scaled_back(length) + scaled_by(steps[i].length);
            length = steps[i].length;
            text += 'd';
        }
        return text + ']';
    }

    std::string entry_text(const std::vector<NamedPart>& parts) const {
        std::string text = options_.name + " {" + (grammar_.title.empty() ? "" : " ; " + comment(grammar_.title)) + '\n';
        text += "  ; Written by Rinceau for Fractint and Iterated Dynamics. Draw it with float=yes, order " +
                std::to_string(parts.back().depth) + " (params=" + std::to_string(parts.back().depth) +
                ") and its colors=@.map\n";
        for (const std::string& line : grammar_.comments) text += "  ; " + comment(line) + '\n';
        text += names_text(parts);
        text += "  Angle 4\n";
        text += std::string("  Axiom \\90") + parts.back().name + '\n';
        // a first rule of several lines would be taken for several rules
        const auto first =
            std::ranges::find_if(parts, [](const NamedPart& part) { return part.text.size() < longest_line; });
        text += first == parts.end() ? "  q=!!\n" : rule_text(*first);
        for (const NamedPart& part : parts) {
            if (first == parts.end() || part.name != first->name) text += rule_text(part);
        }
        return text + "}\n";
    }

    /// Which names are shapes.
    std::string names_text(const std::vector<NamedPart>& parts) const {
        std::string text;
        for (const NamedPart& part : parts) {
            for (const auto& [shape, number] : shapes_) {
                if (part.text == string_.atoms[static_cast<std::size_t>(number)])
                    text += std::string("  ; ") + part.name + " is " +
                            grammar_.terminals[static_cast<std::size_t>(shape.first)].symbol + '\n';
            }
        }
        return text;
    }

    static std::string comment(std::string_view line) {
        std::string text = one_line(line).substr(0, longest_line);
        std::ranges::replace_if(
            text, [](char c) { return c == '{' || c == '}'; }, '|');
        return text;
    }

    /// Lines of one symbol add up.
    static std::string rule_text(const NamedPart& part) {
        const std::string begin = std::string("  ") + part.name + '=';
        std::string text;
        std::string line = begin;
        for (const std::string& piece : split(part.pieces)) {
            if (line.size() > begin.size() && line.size() + piece.size() > longest_line) {
                text += line + '\n';
                line = begin;
            }
            line += piece;
        }
        return text + line + '\n';
    }

    /// Shapes are long: every command of them is a piece.
    static std::vector<std::string> split(const std::vector<std::string>& pieces) {
        std::vector<std::string> commands;
        for (const std::string& piece : pieces) {
            for (std::size_t i = 0; i < piece.size(); ++i) {
                const char c = piece[i];
                const bool goes_on = i > 0 && ((c >= '0' && c <= '9') || c == '.' || (c == 'i' && piece[i - 1] == '@'));
                if (goes_on) {
                    commands.back() += c;
                } else {
                    commands.emplace_back(1, c);
                }
            }
        }
        return commands;
    }

    /// 256 lines of red, green and blue; the background is white.
    std::string map_text() const {
        constexpr std::size_t colors = 256;
        std::vector<Color> map{{255, 255, 255}};
        map.insert(map.end(), palette_.colors().begin(), palette_.colors().end());
        map.resize(colors);
        std::string text;
        for (const Color color : map)
            text += std::to_string(color.red) + ' ' + std::to_string(color.green) + ' ' + std::to_string(color.blue) + '\n';
        return text;
    }

    void add_notes(Export& result) const {
        result.notes.insert(result.notes.begin(),
                            "Fractint has no numbers in rules: what the rules make is written, repeated parts as symbols.");
        const auto fills = [](const NumberedStyle& style) { return paints_fill(style.style); };
        if (std::ranges::any_of(grammar_.styles, fills) || grammar_.styles.empty())
            result.notes.emplace_back("Fractint draws lines only: filled shapes are their outlines.");
        const auto strokes = [](const NumberedStyle& style) { return paints_stroke(style.style); };
        if (std::ranges::any_of(grammar_.styles, strokes)) result.notes.emplace_back("Fractint's lines are one dot wide.");
        if (palette_.overflowed())
            result.notes.emplace_back("Fractint has 255 colours: the others are the nearest of them.");
        if (result.bytes.size() > dos_size)
            result.notes.push_back("The entry has " + std::to_string(result.bytes.size()) +
                                   " characters: more than Fractint for DOS has room for.");
    }
};

bool has_homomorphisms(const Grammar& grammar) {
    return std::ranges::any_of(grammar.productions,
                               [](const Production& production) { return production.kind == ProductionKind::homomorphism; });
}

}  // namespace

Export to_fractint(const Grammar& grammar, const ExportOptions& options) {
    expect_outlines(grammar, "Fractint");
    if (has_homomorphisms(grammar) || has_color_commands(grammar)) {
        const Grammar flat = colors_as_styles(flat_grammar(grammar, options.derive));
        return FractintWriter(flat, {.name = options.name}).write();
    }
    return FractintWriter(grammar, options).write();
}

}  // namespace rinceau
