#include "growth/figures.h"

#include <algorithm>
#include <map>
#include <set>

#include "growth/figure_groups.h"
#include "growth/figure_parts.h"
#include "growth/figure_poses.h"
#include "lsystem/grammar_names.h"
#include "lsystem/measure_symbol.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

using Groups = std::vector<std::vector<int>>;

bool has_production(const Grammar& grammar, const std::string& symbol) {
    return std::ranges::count(grammar.productions, symbol, &Production::symbol) > 0;
}

[[noreturn]] void fail_for_symbol(const Grammar& grammar, const std::string& symbol) {
    std::set<std::string> names;
    for (const Production& production : grammar.productions) names.insert(production.symbol);
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    const SourcePlace place = grammar.axiom.empty() ? SourcePlace{} : SourcePlace{grammar.axiom.front().place.file, 0, 0};
    throw InputError(place, "'" + symbol + "' cannot be an element, because no rule of the grammar expands it; " +
                                (list.empty() ? "the grammar has no rules" : "symbols that can be raised are " + list));
}

/// A raised symbol's expansion.
struct Raised {
    std::string symbol;
    std::vector<int> parts;
};

/// What the raised symbols draw, by expansion.
std::vector<Raised> raised_groups(const FigureParts& parts, const std::vector<std::string>& symbols) {
    const std::set<std::string> stopped(symbols.begin(), symbols.end());
    std::map<std::vector<int>, Raised> by_address;
    for (const std::string& symbol : stopped) {
        if (!has_production(parts.grammar, symbol)) fail_for_symbol(parts.grammar, symbol);
        for (const SymbolInstance& instance : find_instances(parts.grammar, symbol, stopped))
            by_address[instance.address] = {symbol, {}};
    }
    for (std::size_t i = 0; i < parts.parts.size(); ++i) {
        const std::vector<int>& address = parts.parts[i].placement.address;
        std::vector<int> front;
        for (const int step : address) {
            front.push_back(step);
            const auto found = by_address.find(front);
            if (found == by_address.end()) continue;
            found->second.parts.push_back(static_cast<int>(i));
            break;  // the outer one takes it
        }
    }
    std::vector<Raised> result;
    for (auto& [address, raised] : by_address)
        if (!raised.parts.empty()) result.push_back(std::move(raised));
    return result;
}

struct NamedGroup {
    std::string symbol;
    std::vector<int> parts;
};

std::string group_symbol(const FigureParts& parts, const std::vector<int>& group) {
    std::vector<std::string> symbols;
    for (const int i : group) {
        const auto terminal = static_cast<std::size_t>(parts.parts[static_cast<std::size_t>(i)].placement.terminal);
        const std::string& symbol = parts.grammar.terminals[terminal].symbol;
        if (std::ranges::count(symbols, symbol) == 0) symbols.push_back(symbol);
    }
    std::string joined;
    for (const std::string& symbol : symbols) joined += (joined.empty() ? "" : "+") + symbol;
    return joined;
}

std::vector<NamedGroup> named_groups(const FigureParts& parts, const FigureOptions& options,
                                     std::vector<std::string>& warnings) {
    std::vector<NamedGroup> groups;
    std::vector<bool> taken(parts.parts.size());
    if (!options.one_figure && !options.raised.empty())
        for (Raised& raised : raised_groups(parts, options.raised)) {
            for (const int i : raised.parts) taken[static_cast<std::size_t>(i)] = true;
            groups.push_back({std::move(raised.symbol), std::move(raised.parts)});
        }
    for (const int i : background_parts(parts, options.one_figure)) {
        if (taken[static_cast<std::size_t>(i)]) continue;
        taken[static_cast<std::size_t>(i)] = true;
        warnings.push_back(group_symbol(parts, {i}) +
                           " covers or crosses most of the picture: it is taken for the background and is no element");
    }
    std::vector<int> others;
    for (std::size_t i = 0; i < parts.parts.size(); ++i)
        if (!taken[i]) others.push_back(static_cast<int>(i));
    Groups rest;
    if (options.one_figure)
        rest = others.empty() ? Groups{} : Groups{others};
    else if (options.group)
        rest = grouped_parts(parts, others);
    else
        for (const int i : others) rest.push_back({i});
    for (auto& group : rest) {
        std::string symbol = group_symbol(parts, group);
        groups.push_back({std::move(symbol), std::move(group)});
    }
    std::ranges::stable_sort(groups, {}, [](const NamedGroup& group) { return group.parts.front(); });
    return groups;
}

/// In a frame of its own: as in the scene, but about the middle of its box.
Figure made_figure(const FigureParts& parts, const NamedGroup& group, Similarity& frame) {
    Region outline;
    for (const int i : group.parts) {
        const Region& region = parts.parts[static_cast<std::size_t>(i)].region;
        outline = outline.empty() ? region : union_of(outline, region);
    }
    frame = translate(center(bounds(outline)));
    Figure figure{.symbol = group.symbol, .outline = transformed(outline, inverse(frame))};
    for (const int i : group.parts) {
        Placement placement = parts.parts[static_cast<std::size_t>(i)].placement;
        placement.pose = inverse(frame) * placement.pose;
        placement.address.clear();
        figure.parts.push_back(std::move(placement));
    }
    for (const auto& polygon : figure.outline)
        for (const Point corner : polygon) figure.radius = std::max(figure.radius, abs(corner));
    return figure;
}

/// Sorts groups into figures.
class FigureSorter {
  public:
    FigureSorter(const FigureParts& parts, FiguredDrawing& drawing) : parts_(parts), drawing_(drawing) {}

    void add(const NamedGroup& group) {
        const bool whole =
            std::ranges::none_of(group.parts, [&](int i) { return parts_.parts[static_cast<std::size_t>(i)].cut; });
        auto& alike = by_looks_[looks_of(parts_, group.parts)];
        for (const int figure : alike) {
            const auto index = static_cast<std::size_t>(figure);
            if (const auto map = same_figure(parts_, firsts_[index], group.parts)) {
                drawing_.instances.push_back({figure, *map * frames_[index], whole});
                return;
            }
        }
        Similarity frame;
        Figure figure = made_figure(parts_, group, frame);
        if (const int copies = ++names_[figure.symbol]; copies > 1) figure.symbol += "." + std::to_string(copies);
        const int index = static_cast<int>(drawing_.figures.size());
        alike.push_back(index);
        drawing_.figures.push_back(std::move(figure));
        drawing_.instances.push_back({index, frame, whole});
        firsts_.push_back(group.parts);
        frames_.push_back(frame);
    }

  private:
    const FigureParts& parts_;
    FiguredDrawing& drawing_;
    std::map<std::vector<std::vector<int>>, std::vector<int>> by_looks_;
    std::map<std::string, int> names_;
    std::vector<std::vector<int>> firsts_;  ///< by figure: parts of its first copy
    std::vector<Similarity> frames_;        ///< of it
};

}  // namespace

FiguredDrawing figures_of(const Grammar& grammar, const FigureOptions& options, const Progress& progress) {
    FigureParts parts = figure_parts(grammar, options.deviation, progress);
    FiguredDrawing drawing{.warnings = parts.warnings};
    const std::vector<NamedGroup> groups = named_groups(parts, options, drawing.warnings);
    FigureSorter sorter(parts, drawing);
    for (std::size_t g = 0; g < groups.size(); ++g) {
        report(progress, "figures", static_cast<double>(g) / static_cast<double>(groups.size()));
        sorter.add(groups[g]);
    }
    drawing.grammar = std::move(parts.grammar);
    return drawing;
}

}  // namespace rinceau
