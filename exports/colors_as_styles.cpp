#include "exports/colors_as_styles.h"

#include <algorithm>
#include <map>

#include "lsystem/drawn_style.h"
#include "lsystem/grammar_names.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

using Modules = std::vector<ModuleTemplate>;

/// The style in force and what repaints it.
struct Look {
    int style = 0;
    Repaint repaint;
};

bool is_color_command(const ModuleTemplate& module) { return module.symbol == "fill" || module.symbol == "stroke"; }

std::optional<Color> color_of(const ModuleTemplate& module) {
    if (module.arguments.size() != 3) return std::nullopt;
    const auto channel = [&](std::size_t i) {
        return static_cast<std::uint8_t>(module.arguments[i].postfix.front().number);
    };
    return Color{channel(0), channel(1), channel(2)};
}

class StyleAdder {
  public:
    explicit StyleAdder(Grammar& grammar) : grammar_(grammar) {
        for (const NumberedStyle& style : grammar.styles) next_ = std::max(next_, style.number + 1);
    }

    /// The number of the style in which a symbol looks like this.
    int number_of(const Look& look, const std::string& symbol) {
        int base = look.style;
        const auto terminal = std::ranges::find(grammar_.terminals, symbol, &Terminal::symbol);
        if (base == 0 && terminal != grammar_.terminals.end()) base = terminal->style;
        const auto key = std::pair(base, text_of(look.repaint));
        const auto [found, is_new] = numbers_.try_emplace(key, next_);
        if (is_new) {
            const auto style = std::ranges::find(grammar_.styles, base, &NumberedStyle::number);
            NumberedStyle added{.number = next_++};
            added.style = repainted(style == grammar_.styles.end() ? Style{} : style->style, look.repaint);
            grammar_.styles.push_back(std::move(added));
        }
        return found->second;
    }

  private:
    Grammar& grammar_;
    int next_ = 1;
    std::map<std::pair<int, std::string>, int> numbers_;

    static std::string text_of(const Repaint& repaint) {
        std::string text;
        for (const std::optional<Color>& color : {repaint.fill, repaint.stroke}) {
            if (color) text += std::to_string((color->red << 16) + (color->green << 8) + color->blue);
            text += ';';
        }
        return text;
    }
};

}  // namespace

bool has_color_commands(const Grammar& grammar) {
    return std::ranges::any_of(grammar.axiom, is_color_command) ||
           std::ranges::any_of(grammar.productions, [](const Production& production) {
               return std::ranges::any_of(production.successor, is_color_command);
           });
}

Grammar colors_as_styles(Grammar flat) {
    if (!has_color_commands(flat)) return flat;
    const Modules axiom = std::move(flat.axiom);
    flat.axiom.clear();
    StyleAdder styles(flat);
    std::vector<Look> looks{{}};
    for (const ModuleTemplate& module : axiom) {
        if (module.symbol == "[") looks.push_back(Look(looks.back()));
        if (module.symbol == "]") looks.pop_back();
        if (module.symbol == ";") looks.back().style = static_cast<int>(*literal_argument(module));
        if (module.symbol == "fill") looks.back().repaint.fill = color_of(module);
        if (module.symbol == "stroke") looks.back().repaint.stroke = color_of(module);
        if (module.symbol == ";" || is_color_command(module)) continue;
        if (find_turtle_command(module.symbol) == nullptr) {
            const Look& look = looks.back();
            const int number = look.repaint == Repaint{} ? look.style : styles.number_of(look, module.symbol);
            if (number != 0) flat.axiom.push_back({";", {number_expression(number)}, {}});
        }
        flat.axiom.push_back(module);
    }
    return flat;
}

}  // namespace rinceau
