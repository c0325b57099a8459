#include "growth/merge_figures.h"

#include <algorithm>
#include <map>
#include <set>

#include "lsystem/turtle_commands.h"

namespace rinceau {
namespace {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

class Merge {
  public:
    FiguredDrawing result;

    void add(const FiguredDrawing& drawing, const std::string& name) {
        const int first_style = add_styles(drawing.grammar);
        for (std::size_t i = 0; i < drawing.figures.size(); ++i) {
            const std::string own = drawing.figures.size() > 1 ? name + std::to_string(i + 1) : name;
            add_figure(drawing, drawing.figures[i], own, first_style);
        }
        result.warnings.insert(result.warnings.end(), drawing.warnings.begin(), drawing.warnings.end());
    }

  private:
    std::set<std::string> taken_;
    int last_style_ = 0;

    std::string free_name(const std::string& wish) {
        std::string name = wish;
        std::ranges::replace_if(
            name, [](char c) { return !is_letter(c) && !is_digit(c); }, '_');
        if (name.empty() || is_digit(name.front())) name.insert(name.begin(), 'S');
        std::string unique = name;
        for (int k = 2; taken_.count(unique) > 0 || find_turtle_command(unique) != nullptr; ++k)
            unique = name + "_" + std::to_string(k);
        taken_.insert(unique);
        return unique;
    }

    /// What is added to the drawing's own numbers.
    int add_styles(const Grammar& grammar) {
        const int before = last_style_;
        for (NumberedStyle style : grammar.styles) {
            style.number += before;
            last_style_ = std::max(last_style_, style.number);
            result.grammar.styles.push_back(std::move(style));
        }
        return before;
    }

    void add_figure(const FiguredDrawing& drawing, const Figure& figure, const std::string& wish, int first_style) {
        Figure added = figure;
        added.symbol = free_name(wish);
        std::map<int, int> terminals;  // the drawing's -> the result's
        for (Placement& part : added.parts) {
            const auto [known, is_new] =
                terminals.try_emplace(part.terminal, static_cast<int>(result.grammar.terminals.size()));
            if (is_new) {
                Terminal terminal = drawing.grammar.terminals[static_cast<std::size_t>(part.terminal)];
                const std::string letter(1, static_cast<char>('a' + (terminals.size() - 1) % 26));
                terminal.symbol = figure.parts.size() == 1 ? added.symbol : free_name(added.symbol + "_" + letter);
                if (terminal.style != 0) terminal.style += first_style;
                result.grammar.terminals.push_back(std::move(terminal));
            }
            part.terminal = known->second;
            if (part.style != 0) part.style += first_style;
        }
        result.figures.push_back(std::move(added));
    }
};

}  // namespace

FiguredDrawing merged_figures(std::span<const FiguredDrawing> drawings, std::span<const std::string> names) {
    Merge merge;
    if (!drawings.empty()) {
        merge.result.grammar.canvas = drawings.front().grammar.canvas;
        merge.result.grammar.sized = drawings.front().grammar.sized;
    }
    for (std::size_t k = 0; k < drawings.size(); ++k) merge.add(drawings[k], names[k]);
    return std::move(merge.result);
}

}  // namespace rinceau
