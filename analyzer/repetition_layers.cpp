#include "analyzer/repetition_layers.h"

#include <algorithm>
#include <map>
#include <optional>

#include "analyzer/repetition.h"

namespace rinceau {

namespace {

constexpr int most_productions = 3;  // that get a layer: each is one more thing to understand

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// A production that repeats, and for each leaf how many repetitions of it lie before.
struct Turns {
    Repetition repetition;
    std::vector<int> of_leaf;
};

std::vector<Turns> turns_of_leaves(const Grammar& grammar, const std::vector<Placement>& leaves, const DerivationTree& tree) {
    std::map<int, std::size_t> turns_of_production;
    std::vector<Turns> all;
    for (const Production& production : grammar.productions) {
        const auto repetition = repetition_of(grammar, production.symbol);
        if (!repetition) continue;
        turns_of_production[repetition->production] = all.size();
        all.push_back({*repetition, std::vector<int>(leaves.size(), 0)});
    }
    for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf) {
        for (int n = tree.node_of_leaf[leaf]; n > 0; n = tree.nodes[index(n)].parent) {
            const auto found = turns_of_production.find(tree.sites[index(tree.nodes[index(n)].site)].string);
            if (found == turns_of_production.end()) continue;
            Turns& turns = all[found->second];
            turns.of_leaf[leaf] += turn_of(tree, leaves, n, turns.repetition);
        }
    }
    return all;
}

std::size_t wrong_pairs(const std::vector<LeafPair>& pairs, const std::vector<int>& layers, const std::vector<int>& turns, int by) {
    return static_cast<std::size_t>(std::ranges::count_if(pairs, [&](const LeafPair& pair) {
        const auto layer = [&](int leaf) { return layers[index(leaf)] + by * turns[index(leaf)]; };
        return layer(pair.upper) < layer(pair.lower) + (pair.lower > pair.upper ? 1 : 0);
    }));
}

}  // namespace

Grammar with_repetition_layers(const Grammar& grammar, const std::vector<Placement>& leaves, const DerivationTree& tree,
                               const std::vector<LeafPair>& pairs) {
    Grammar result = grammar;
    std::vector<int> layers;
    for (const Placement& leaf : leaves) layers.push_back(leaf.layer);
    std::vector<Turns> all = turns_of_leaves(grammar, leaves, tree);
    const std::vector<int> none(leaves.size(), 0);
    std::size_t wrong = wrong_pairs(pairs, layers, none, 0);
    for (int round = 0; round < most_productions && wrong > 0; ++round) {
        std::size_t best = all.size(), least = wrong;
        int best_by = 0;
        for (std::size_t k = 0; k < all.size(); ++k) {
            for (const int by : {1, -1, 2, -2}) {
                const std::size_t left = wrong_pairs(pairs, layers, all[k].of_leaf, by);
                if (left >= least) continue;
                least = left;
                best = k;
                best_by = by;
            }
        }
        if (best == all.size() || 2 * least > wrong) break;
        for (std::size_t leaf = 0; leaf < layers.size(); ++leaf) layers[leaf] += best_by * all[best].of_leaf[leaf];
        std::vector<ModuleTemplate>& body = result.productions[index(all[best].repetition.production)].successor;
        body.insert(body.end() - 1, {.symbol = "z", .arguments = {number_expression(best_by)}});
        all.erase(all.begin() + static_cast<std::ptrdiff_t>(best));
        wrong = least;
    }
    return result;
}

}  // namespace rinceau
