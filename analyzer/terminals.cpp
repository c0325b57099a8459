#include "analyzer/terminals.h"

#include <algorithm>
#include <cmath>

namespace rinceau {

namespace {

double decimal_unit(double slack) { return std::pow(10, std::floor(std::log10(slack))); }

/// x as the nearest double to its decimal: k * 10^-n as a quotient, so that it prints with n decimals.
double decimal(double x, double unit) {
    if (unit >= 1) return std::round(x / unit) * unit;
    const double per_one = std::round(1 / unit);
    return std::round(x * per_one) / per_one;
}

std::vector<Path> rounded_paths(std::vector<Path> paths, double slack) {
    const double unit = decimal_unit(slack);
    const auto round_point = [&](Point& p) { p = {decimal(p.x, unit), decimal(p.y, unit)}; };
    for (Path& path : paths) {
        round_point(path.start);
        for (Segment& segment : path.segments) {
            round_point(segment.control1);
            round_point(segment.control2);
            round_point(segment.to);
        }
    }
    return paths;
}

double tidy_length(double value) {
    // Six digits: a millionth of a stroke's width is never seen, unless it is wider than any page.
    constexpr double any_page = 10'000;
    if (!(value > 0) || value > any_page) return value;
    const double unit = std::pow(10, std::floor(std::log10(value)) - 5);
    return decimal(value, unit);
}

Style tidied(Style style) {
    if (!paints_stroke(style)) style.stroke = {};
    style.stroke.width = tidy_length(style.stroke.width);
    for (double& dash : style.stroke.dashes) dash = tidy_length(dash);
    return style;
}

}  // namespace

Style terminal_style(const Style& unit_style, const Similarity& anchor) {
    return tidied(transformed(unit_style, inverse(anchor)));
}

int style_number(std::vector<NumberedStyle>& styles, const Style& style) {
    constexpr double equal = 1e-6;
    for (const NumberedStyle& known : styles) {
        const bool scale_alike = known.style.stroke.fixed == style.stroke.fixed || !paints_stroke(style);
        if (scale_alike && same_style(known.style, style, equal)) return known.number;
    }
    const int number = static_cast<int>(styles.size()) + 1;
    styles.push_back({number, style, ""});
    return number;
}

void add_terminals(Grammar& grammar, const Instancing& instancing, const Scene& scene, const std::vector<int>& looks,
                   const std::vector<std::string>& names, const std::vector<Similarity>& anchors, double slack) {
    std::vector<int> first(instancing.looks.size(), -1);
    for (std::size_t e = instancing.instances.size(); e-- > 0;) {
        first[static_cast<std::size_t>(instancing.instances[e].look)] = static_cast<int>(e);
    }
    for (const int look_number : looks) {
        const auto at = static_cast<std::size_t>(look_number);
        const Look& look = instancing.looks[at];
        Terminal terminal;
        terminal.symbol = names[at];
        if (first[at] >= 0) terminal.id = scene.elements[static_cast<std::size_t>(first[at])].id;
        if (!look.verbatim.empty()) {
            terminal.verbatim = look.verbatim;
            if (first[at] >= 0) terminal.verbatim_box = scene.elements[static_cast<std::size_t>(first[at])].verbatim_box;
        } else {
            const Similarity to_terminal = inverse(anchors[at]);
            terminal.paths = rounded_paths(transformed(look.paths, to_terminal), slack);
            terminal.style = style_number(grammar.styles, terminal_style(look.unit_style, anchors[at]));
        }
        grammar.terminals.push_back(std::move(terminal));
    }
}

}  // namespace rinceau
