#include "growth/arrangement/kinds.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "geometry/angle.h"
#include "growth/figure_parts.h"
#include "growth/figure_shapes.h"

namespace rinceau {
namespace {

double radius_of(const FiguredDrawing& drawing, int instance) {
    const FigureInstance& i = drawing.instances[static_cast<std::size_t>(instance)];
    return drawing.figures[static_cast<std::size_t>(i.figure)].radius * scale_of(i.pose);
}

/// Splits where sizes, sorted, make a step that is wide beside the steps within: small and large stars.
std::vector<std::vector<int>> by_size(const FiguredDrawing& drawing, std::vector<int> instances) {
    constexpr double clearly = 1.6;  // times as large
    const auto size = [&](int i) { return radius_of(drawing, i); };
    std::ranges::stable_sort(instances, {}, size);
    std::vector<std::vector<int>> groups{{}};
    for (const int i : instances) {
        if (!groups.back().empty() && size(i) > clearly * size(groups.back().back())) groups.emplace_back();
        groups.back().push_back(i);
    }
    return groups;
}

Region placed_outline(const FiguredDrawing& drawing, int instance) {
    const FigureInstance& i = drawing.instances[static_cast<std::size_t>(instance)];
    Similarity about_origin = i.pose;
    about_origin.translation = {};
    return transformed(drawing.figures[static_cast<std::size_t>(i.figure)].outline, about_origin);
}

/// Splits copies of a figure that look the same but for where they stand; one group if that makes more than a few, or single
/// ones.
std::vector<std::vector<int>> by_stance(const FiguredDrawing& drawing, const std::vector<int>& instances) {
    constexpr std::size_t most_stances = 4;
    constexpr double same = 0.2;  // of the radius: some ten degrees
    std::vector<std::vector<int>> stances;
    std::vector<Region> outlines;
    for (const int i : instances) {
        const Region outline = placed_outline(drawing, i);
        std::size_t s = 0;
        while (s < stances.size() && !same_outline(outline, outlines[s], same * radius_of(drawing, i))) ++s;
        if (s == stances.size()) {
            if (s == most_stances) return {instances};
            stances.emplace_back();
            outlines.push_back(outline);
        }
        stances[s].push_back(i);
    }
    const bool each_again = std::ranges::all_of(stances, [](const auto& stance) { return stance.size() >= 2; });
    return each_again ? stances : std::vector<std::vector<int>>{instances};
}

/// What paints a figure: of all its parts together.
struct FigurePaint {
    bool fill = false;
    bool stroke = false;
    std::set<std::string> colors;
    friend auto operator<=>(const FigurePaint&, const FigurePaint&) = default;
};

std::string color_name(const Paint& paint, const std::optional<Color>& repaint) {
    if (!std::holds_alternative<Color>(paint)) return "gradient";
    const Color color = repaint.value_or(std::get<Color>(paint));
    return std::to_string(color.red) + "," + std::to_string(color.green) + "," + std::to_string(color.blue);
}

FigurePaint paint_of(const FiguredDrawing& drawing, const Figure& figure) {
    FigurePaint paint;
    for (const Placement& part : figure.parts) {
        const Terminal& terminal = drawing.grammar.terminals[static_cast<std::size_t>(part.terminal)];
        const int number = part.style != 0 ? part.style : terminal.style;
        const auto found = std::ranges::find(drawing.grammar.styles, number, &NumberedStyle::number);
        const Style style = found == drawing.grammar.styles.end() ? Style{} : found->style;
        if (paints_fill(style)) paint.colors.insert("f" + color_name(style.fill, part.repaint.fill));
        if (paints_stroke(style)) paint.colors.insert("s" + color_name(style.stroke.paint, part.repaint.stroke));
        paint.fill = paint.fill || paints_fill(style);
        paint.stroke = paint.stroke || paints_stroke(style);
    }
    return paint;
}

std::vector<std::vector<int>> values_of(const std::map<FigurePaint, std::vector<int>>& groups) {
    std::vector<std::vector<int>> result;
    for (const auto& [paint, members] : groups) result.push_back(members);
    std::ranges::sort(result);
    return result;
}

/// Rare figures by their paint; colours count if each is met at least four times.
std::vector<std::vector<int>> by_paint(const FiguredDrawing& drawing, const std::vector<int>& instances) {
    constexpr std::size_t fewest = 4;
    std::map<FigurePaint, std::vector<int>> colored;
    std::map<FigurePaint, std::vector<int>> plain;
    for (const int i : instances) {
        FigurePaint paint = paint_of(
            drawing, drawing.figures[static_cast<std::size_t>(drawing.instances[static_cast<std::size_t>(i)].figure)]);
        colored[paint].push_back(i);
        paint.colors.clear();
        plain[paint].push_back(i);
    }
    const bool few_colors = std::ranges::all_of(colored, [](const auto& group) { return group.second.size() >= fewest; });
    return values_of(few_colors ? colored : plain);
}

/// What figures are compared by.
struct FigureLook {
    std::vector<int> terminals;
    FigurePaint paint;
    double radius = 0;     ///< median of its copies
    double roundness = 0;  ///< share of the circle about it that it fills, holes too
    std::size_t copies = 0;
};

std::vector<FigureLook> figure_looks(const FiguredDrawing& drawing) {
    std::vector<std::vector<double>> radii(drawing.figures.size());
    for (std::size_t i = 0; i < drawing.instances.size(); ++i)
        radii[static_cast<std::size_t>(drawing.instances[i].figure)].push_back(radius_of(drawing, static_cast<int>(i)));
    std::vector<FigureLook> looks;
    for (std::size_t f = 0; f < drawing.figures.size(); ++f) {
        const Figure& figure = drawing.figures[f];
        FigureLook look{.paint = paint_of(drawing, figure), .copies = radii[f].size()};
        for (const Placement& part : figure.parts) look.terminals.push_back(part.terminal);
        std::ranges::sort(look.terminals);
        std::ranges::sort(radii[f]);
        if (!radii[f].empty()) look.radius = radii[f][radii[f].size() / 2];
        look.roundness = area(without_holes(figure.outline)) / (pi * figure.radius * figure.radius);
        looks.push_back(std::move(look));
    }
    return looks;
}

bool about(double a, double b, double factor) { return a < factor * b && b < factor * a; }

/// Often: at least four times, and a twelfth of all.
std::vector<int> frequent_figures(const std::vector<FigureLook>& looks, std::size_t instances) {
    constexpr std::size_t fewest = 4;
    constexpr std::size_t share = 12;
    std::vector<int> frequent;
    for (std::size_t f = 0; f < looks.size(); ++f)
        if (looks[f].copies >= std::max(fewest, instances / share)) frequent.push_back(static_cast<int>(f));
    return frequent;
}

/// The family that each figure goes with, named by its most frequent figure; -1 = none.
std::vector<int> figure_families(const std::vector<FigureLook>& looks, std::size_t instances) {
    constexpr double as_large = 1.3;
    constexpr double as_round = 1.2;
    std::vector<int> frequent = frequent_figures(looks, instances);
    std::ranges::stable_sort(frequent, std::greater{}, [&](int f) { return looks[static_cast<std::size_t>(f)].copies; });
    std::vector<int> families(looks.size(), -1);
    const auto join = [&](std::size_t f, auto&& alike) {
        for (const int head : frequent) {
            const FigureLook& a = looks[static_cast<std::size_t>(head)];
            const bool leads =
                families[static_cast<std::size_t>(head)] == head || families[static_cast<std::size_t>(head)] < 0;
            if (families[f] >= 0 || !leads || !about(a.radius, looks[f].radius, as_large) || !alike(a, looks[f])) continue;
            families[static_cast<std::size_t>(head)] = head;
            families[f] = head;
        }
    };
    const auto same_terminals = [](const FigureLook& a, const FigureLook& b) { return a.terminals == b.terminals; };
    const auto same_paint = [](const FigureLook& a, const FigureLook& b) {
        return a.paint == b.paint && about(a.roundness, b.roundness, as_round);
    };
    for (const int f : frequent) join(static_cast<std::size_t>(f), same_terminals);
    for (std::size_t f = 0; f < looks.size(); ++f) join(f, same_terminals);
    for (std::size_t f = 0; f < looks.size(); ++f) join(f, same_paint);
    return families;
}

/// The figure that most of them are copies of, the largest of several.
int name_giver(const FiguredDrawing& drawing, const std::vector<int>& members) {
    std::map<int, std::pair<int, double>> copies;  // figure -> number, radius
    for (const int i : members) {
        auto& [count, radius] = copies[drawing.instances[static_cast<std::size_t>(i)].figure];
        ++count;
        radius = std::max(radius, radius_of(drawing, i));
    }
    return std::ranges::max_element(copies, {}, [](const auto& figure) { return figure.second; })->first;
}

void add_kind(const FiguredDrawing& drawing, const std::vector<int>& members, ElementKinds& kinds) {
    const std::string& symbol = drawing.figures[static_cast<std::size_t>(name_giver(drawing, members))].symbol;
    std::string name = symbol;
    for (int copy = 2; std::ranges::count(kinds.names, name) > 0; ++copy) name = symbol + "." + std::to_string(copy);
    for (const int i : members) kinds.of_instance[static_cast<std::size_t>(i)] = static_cast<int>(kinds.names.size());
    kinds.names.push_back(name);
}

}  // namespace

ElementKinds element_kinds(const FiguredDrawing& drawing) {
    const std::vector<int> families = figure_families(figure_looks(drawing), drawing.instances.size());
    std::map<int, std::vector<int>> by_family;
    for (std::size_t i = 0; i < drawing.instances.size(); ++i)
        by_family[families[static_cast<std::size_t>(drawing.instances[i].figure)]].push_back(static_cast<int>(i));
    std::vector<std::vector<int>> groups;
    for (const auto& [family, members] : by_family) {
        const auto painted = family < 0 ? by_paint(drawing, members) : std::vector<std::vector<int>>{members};
        for (const auto& same_paint : painted)
            for (const auto& sized : by_size(drawing, same_paint))
                for (auto& stance : by_stance(drawing, sized)) groups.push_back(std::move(stance));
    }
    std::ranges::sort(groups);
    ElementKinds kinds{.of_instance = std::vector<int>(drawing.instances.size(), 0)};
    for (const auto& members : groups) add_kind(drawing, members, kinds);
    return kinds;
}

}  // namespace rinceau
