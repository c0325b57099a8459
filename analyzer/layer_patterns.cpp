#include "analyzer/layer_patterns.h"

#include <algorithm>
#include <map>
#include <optional>

#include "analyzer/colour_pattern.h"
#include "analyzer/repetition.h"

namespace rinceau {

namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// The layers of the modules at a site as a column over copies and repetitions of its production. (m is counted down from as
/// many repetitions as are seen at the site.)
TintColumn column_of(const DerivationTree& tree, const std::vector<Placement>& leaves, const std::vector<int>& nodes,
                     const Repetition& repetition, const std::vector<int>& layers) {
    TintColumn column;
    column.counter = repetition.counter;
    std::map<int, int> owner_of_parent;
    std::vector<int> turns;
    for (const int n : nodes) {
        const auto [owner, added] =
            owner_of_parent.try_emplace(tree.nodes[index(n)].parent, static_cast<int>(owner_of_parent.size()));
        if (added) column.counts.push_back(0);
        const int turn = turn_of(tree, leaves, n, repetition);
        int& count = column.counts[index(owner->second)];
        count = std::max(count, turn + 1);
        turns.push_back(turn);
        column.uses.push_back({owner->second, 0, layers[index(n)]});
    }
    for (std::size_t k = 0; k < turns.size(); ++k) column.uses[k].m = column.counts[index(column.uses[k].owner)] - turns[k];
    column.owners = static_cast<int>(owner_of_parent.size());
    return column;
}

}  // namespace

std::vector<LayerPattern> layer_patterns(const Grammar& grammar, const std::vector<Placement>& leaves, const DerivationTree& tree,
                                         const std::vector<std::vector<int>>& nodes_of_site, const std::vector<int>& layers) {
    constexpr double exception_bits = 20;       // a line with an address
    constexpr std::ptrdiff_t worth_while = 3;   // exceptions
    std::vector<LayerPattern> patterns;
    for (std::size_t s = 0; s < nodes_of_site.size(); ++s) {
        const std::vector<int>& nodes = nodes_of_site[s];
        const ModuleSite& site = tree.sites[s];
        const std::ptrdiff_t raised = std::ranges::count_if(nodes, [&](int n) { return layers[index(n)] != 0; });
        if (site.string < 0 || raised < worth_while) continue;
        const std::vector<ModuleTemplate>& string = string_at(grammar, site);
        if (index(site.position) + 1 >= string.size() || string[index(site.position) + 1].symbol != "]") continue;
        const auto repetition = repetition_of(grammar, grammar.productions[index(site.string)].symbol);
        if (!repetition) continue;
        TintPattern found =
            shortest_pattern(column_of(tree, leaves, nodes, *repetition, layers), {}, "", exception_bits);
        if (static_cast<std::ptrdiff_t>(found.departures.size()) + worth_while > raised) continue;
        LayerPattern pattern{static_cast<int>(s), std::move(found.expression), std::vector<int>(nodes.size(), 0)};
        for (std::size_t k = 0; k < found.departures.size(); ++k) {
            const std::size_t use = index(found.departures[k]);
            pattern.rest[use] = static_cast<int>(found.missing[k]);
        }
        patterns.push_back(std::move(pattern));
    }
    return patterns;
}

}  // namespace rinceau
