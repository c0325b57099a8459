// docs/analysis.md, 8. Layers on the modules of the grammar's text first, for all their copies at once; then
// exceptions for single modules of the derivation; last, where groups interleave, for single leaves, which always works.

#include "analyzer/paint_order.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <utility>

#include "analyzer/derivation_tree.h"
#include "analyzer/layer_demands.h"
#include "analyzer/layer_patterns.h"
#include "analyzer/layer_text.h"
#include "analyzer/repetition_layers.h"
#include "lsystem/interpret.h"

namespace rinceau {
namespace {

/// Everything that stays the same while layers are tried.
struct Problem {
    const Grammar& grammar;
    std::vector<Placement> leaves;   ///< in order of derivation
    std::vector<LeafPair> pairs;     ///< sorted by paint order of `upper` in the drawing
    std::vector<LeafPair> from_top;  ///< the same sorted by falling paint order of `lower`
    DerivationTree tree;
    LayerHierarchy sites;    ///< of the paths of the tree, a variable for each site
    LayerHierarchy modules;  ///< of the nodes of the tree, a variable for each node
};

/// Layers that make the order right.
struct Plan {
    std::vector<int> site_layers;
    std::vector<int> module_layers;
    std::map<int, Expression> site_expressions;  ///< by site, beside its layer
    std::size_t cost = 0;
};

int at(const std::vector<int>& values, int index) { return values[static_cast<std::size_t>(index)]; }

int step_needed(const LeafPair& pair) { return pair.lower > pair.upper ? 1 : 0; }

bool in_order(const std::vector<LeafPair>& pairs, const std::vector<int>& layers) {
    return std::all_of(pairs.begin(), pairs.end(), [&](const LeafPair& pair) {
        return at(layers, pair.upper) >= at(layers, pair.lower) + step_needed(pair);
    });
}

std::vector<LeafPair> leaf_pairs(const std::vector<int>& element_of_leaf, const Overlaps& overlaps) {
    int elements = 0;
    for (const int element : element_of_leaf) elements = std::max(elements, element + 1);
    for (const OverlapPair& pair : overlaps.pairs) elements = std::max(elements, pair.upper + 1);
    std::vector<int> leaf_of(static_cast<std::size_t>(elements), -1);
    for (std::size_t k = 0; k < element_of_leaf.size(); ++k) {
        if (element_of_leaf[k] >= 0) leaf_of[static_cast<std::size_t>(element_of_leaf[k])] = static_cast<int>(k);
    }
    std::vector<LeafPair> pairs;
    for (const OverlapPair& pair : overlaps.pairs) {
        const LeafPair leaves{at(leaf_of, pair.lower), at(leaf_of, pair.upper)};
        if (leaves.lower >= 0 && leaves.upper >= 0) pairs.push_back(leaves);
    }
    return pairs;
}

/// Arguments that mean the same wherever the module is written.
bool uses_constants_only(const Grammar& grammar, const ModuleSite& site) {
    if (site.string < 0) return true;
    const std::vector<std::string>& parameters = grammar.productions[static_cast<std::size_t>(site.string)].parameters;
    for (const Expression& argument : string_at(grammar, site)[static_cast<std::size_t>(site.position)].arguments) {
        for (const Expression::Node& node : argument.postfix) {
            const bool name = node.op == Expression::Op::name;
            if (name && std::find(parameters.begin(), parameters.end(), node.name) != parameters.end()) return false;
        }
    }
    return true;
}

/// Could an exception raise the module alone? Not where one stands already, nor where its arguments would lose their
/// meaning.
std::vector<bool> exceptable(const Grammar& grammar, const DerivationTree& tree) {
    std::vector<bool> can(tree.nodes.size(), false);
    for (std::size_t n = 1; n < tree.nodes.size(); ++n) {
        const ModuleSite& site = tree.sites[static_cast<std::size_t>(tree.nodes[n].site)];
        can[n] = site.string > exception_string && uses_constants_only(grammar, site);
        if (site.string <= exception_string) {
            can[static_cast<std::size_t>(tree.nodes[n].parent)] = false;
            can[n] = at(tree.nodes_of_site, tree.nodes[n].site) == 1;  // written into the exception itself
        }
    }
    return can;
}

LayerHierarchy site_hierarchy(const DerivationTree& tree) {
    LayerHierarchy hierarchy{
        .parent = tree.site_parent, .variable = tree.path_site, .variables = static_cast<int>(tree.sites.size())};
    hierarchy.depth.assign(tree.site_parent.size(), 0);
    for (std::size_t i = 1; i < tree.site_parent.size(); ++i)
        hierarchy.depth[i] = at(hierarchy.depth, tree.site_parent[i]) + 1;
    return hierarchy;
}

LayerHierarchy module_hierarchy(const Grammar& grammar, const DerivationTree& tree) {
    const std::vector<bool> can = exceptable(grammar, tree);
    LayerHierarchy hierarchy{.variables = static_cast<int>(tree.nodes.size())};
    for (std::size_t n = 1; n < tree.nodes.size(); ++n) {
        hierarchy.parent.push_back(tree.nodes[n].parent);
        hierarchy.depth.push_back(tree.nodes[n].depth);
        hierarchy.variable.push_back(can[n] ? static_cast<int>(n) : -1);
    }
    return hierarchy;
}

Problem state_problem(const Grammar& grammar, const std::vector<int>& element_of_leaf, const Overlaps& overlaps) {
    Problem problem{.grammar = grammar, .leaves = interpret(grammar, {.addresses = true, .trails = true})};
    std::sort(problem.leaves.begin(), problem.leaves.end(),
              [](const Placement& a, const Placement& b) { return a.order < b.order; });
    assert(problem.leaves.size() == element_of_leaf.size());
    problem.pairs = leaf_pairs(element_of_leaf, overlaps);
    problem.from_top = problem.pairs;
    std::stable_sort(problem.from_top.begin(), problem.from_top.end(), [&](const LeafPair& a, const LeafPair& b) {
        return at(element_of_leaf, a.lower) > at(element_of_leaf, b.lower);
    });
    problem.tree = derivation_tree(grammar, problem.leaves);
    problem.sites = site_hierarchy(problem.tree);
    problem.modules = module_hierarchy(grammar, problem.tree);
    return problem;
}

/// The pairs as demands on the merged tree: one for each pair of paths. Two leaves of one path cannot be told apart there.
std::vector<LayerDemand> site_demands(const Problem& problem) {
    std::map<std::pair<int, int>, std::size_t> known;
    std::vector<LayerDemand> demands;
    for (const LeafPair& pair : problem.pairs) {
        const auto path = [&](int leaf) {
            return problem.tree.nodes[static_cast<std::size_t>(at(problem.tree.node_of_leaf, leaf))].path;
        };
        const auto layer = [&](int leaf) { return problem.leaves[static_cast<std::size_t>(leaf)].layer; };
        const int lower = path(pair.lower);
        const int upper = path(pair.upper);
        if (lower == upper) continue;
        const int need = step_needed(pair) + layer(pair.lower) - layer(pair.upper);
        const auto [known_at, added] = known.try_emplace({lower, upper}, demands.size());
        if (added) {
            demands.push_back({lower, upper, need, 1});
        } else {
            LayerDemand& demand = demands[known_at->second];
            demand.need = std::max(demand.need, need);
            ++demand.pairs;
        }
    }
    return demands;
}

std::vector<LayerDemand> module_demands(const Problem& problem, const std::vector<int>& layers) {
    std::vector<LayerDemand> demands;
    for (const LeafPair& pair : problem.pairs) {
        demands.push_back({at(problem.tree.node_of_leaf, pair.lower), at(problem.tree.node_of_leaf, pair.upper),
                           step_needed(pair) + at(layers, pair.lower) - at(layers, pair.upper), 1});
    }
    return demands;
}

std::vector<int> layers_of_leaves(const Problem& problem, const Plan& plan) {
    std::vector<int> layers;
    for (std::size_t k = 0; k < problem.leaves.size(); ++k) {
        const int node = problem.tree.node_of_leaf[k];
        const int path = problem.tree.nodes[static_cast<std::size_t>(node)].path;
        layers.push_back(problem.leaves[k].layer + layer_of(problem.sites, plan.site_layers, path) +
                         layer_of(problem.modules, plan.module_layers, node));
    }
    return layers;
}

/// Raises (or lowers) single leaves until the order is right: in one pass, because the drawing's own order is one.
void settle_leaves(const Problem& problem, LayerDirection direction, Plan& plan) {
    const std::vector<int> before = layers_of_leaves(problem, plan);
    std::vector<int> layers = before;
    const auto layer = [&](int leaf) -> int& { return layers[static_cast<std::size_t>(leaf)]; };
    if (direction == LayerDirection::raise) {
        for (const LeafPair& p : problem.pairs) layer(p.upper) = std::max(layer(p.upper), layer(p.lower) + step_needed(p));
    } else {
        for (const LeafPair& p : problem.from_top)
            layer(p.lower) = std::min(layer(p.lower), layer(p.upper) - step_needed(p));
    }
    for (std::size_t k = 0; k < layers.size(); ++k) {
        plan.module_layers[static_cast<std::size_t>(problem.tree.node_of_leaf[k])] += layers[k] - before[k];
    }
}

/// What all modules of a site have in common is said once, at the site; what one exception cannot say must be said there.
void move_common_layers_to_sites(const Problem& problem, Plan& plan) {
    std::vector<std::vector<int>> nodes(problem.tree.sites.size());
    for (std::size_t n = 1; n < problem.tree.nodes.size(); ++n) {
        nodes[static_cast<std::size_t>(problem.tree.nodes[n].site)].push_back(static_cast<int>(n));
    }
    for (std::size_t s = 0; s < nodes.size(); ++s) {
        const int common = at(plan.module_layers, nodes[s].front());
        const bool same =
            std::all_of(nodes[s].begin(), nodes[s].end(), [&](int n) { return at(plan.module_layers, n) == common; });
        if (!same || common == 0) continue;
        plan.site_layers[s] += common;
        for (const int n : nodes[s]) plan.module_layers[static_cast<std::size_t>(n)] = 0;
    }
}

/// What follows a counter is said by it.
void move_patterns_to_sites(const Problem& problem, Plan& plan) {
    std::vector<std::vector<int>> nodes(problem.tree.sites.size());
    for (std::size_t n = 1; n < problem.tree.nodes.size(); ++n) {
        nodes[static_cast<std::size_t>(problem.tree.nodes[n].site)].push_back(static_cast<int>(n));
    }
    for (LayerPattern& pattern : layer_patterns(problem.grammar, problem.leaves, problem.tree, nodes, plan.module_layers)) {
        const std::vector<int>& here = nodes[static_cast<std::size_t>(pattern.site)];
        for (std::size_t k = 0; k < here.size(); ++k) plan.module_layers[static_cast<std::size_t>(here[k])] = pattern.rest[k];
        plan.site_expressions[pattern.site] = std::move(pattern.by);
    }
}

std::size_t count_nonzero(const std::vector<int>& values) {
    return values.size() - static_cast<std::size_t>(std::count(values.begin(), values.end(), 0));
}

/// A z command is one module, an exception a line with an address.
std::size_t cost_of(const Plan& plan) {
    constexpr std::size_t modules_per_exception = 3;
    std::size_t expressions = 0;  // a module, and what there is to calculate
    for (const auto& [unused, expression] : plan.site_expressions) expressions += 3 + expression.postfix.size() / 2;
    return count_nonzero(plan.site_layers) + expressions + modules_per_exception * count_nonzero(plan.module_layers);
}

/// Plans that start from the given layers of sites: exceptions for leaves, or for the largest modules that can move as one.
std::vector<Plan> complete_plans(const Problem& problem, const std::vector<int>& site_layers) {
    const Plan start{.site_layers = site_layers, .module_layers = std::vector<int>(problem.tree.nodes.size(), 0)};
    const std::vector<int> layers = layers_of_leaves(problem, start);
    if (in_order(problem.pairs, layers)) return {start};
    const std::vector<LayerDemand> demands = module_demands(problem, layers);
    std::vector<Plan> plans;
    for (const LayerDirection direction : {LayerDirection::raise, LayerDirection::lower}) {
        plans.push_back(start);
        settle_leaves(problem, direction, plans.back());
        plans.push_back(start);
        plans.back().module_layers = meet_demands(problem.modules, demands, direction, false).values;
        settle_leaves(problem, direction, plans.back());
    }
    return plans;
}

/// All that come to mind, cheapest first.
std::vector<Plan> plans_by_cost(const Problem& problem) {
    const std::vector<LayerDemand> demands = site_demands(problem);
    std::vector<std::vector<int>> starts{std::vector<int>(problem.tree.sites.size(), 0)};
    for (const LayerDirection direction : {LayerDirection::raise, LayerDirection::lower}) {
        starts.push_back(meet_demands(problem.sites, demands, direction, true).values);
    }
    std::vector<Plan> plans;
    for (const std::vector<int>& start : starts) {
        for (Plan& plan : complete_plans(problem, start)) {
            move_common_layers_to_sites(problem, plan);
            move_patterns_to_sites(problem, plan);
            plan.cost = cost_of(plan);
            plans.push_back(std::move(plan));
        }
    }
    std::stable_sort(plans.begin(), plans.end(), [](const Plan& a, const Plan& b) { return a.cost < b.cost; });
    return plans;
}

Grammar written(const Problem& problem, const Plan& plan) {
    std::vector<SiteLayer> sites;
    for (std::size_t s = 0; s < plan.site_layers.size(); ++s) {
        const auto found = plan.site_expressions.find(static_cast<int>(s));
        if (found != plan.site_expressions.end()) {
            sites.push_back({problem.tree.sites[s], plan.site_layers[s], found->second});
        } else if (plan.site_layers[s] != 0) {
            sites.push_back({problem.tree.sites[s], plan.site_layers[s], {}});
        }
    }
    std::vector<AddressLayer> exceptions;
    for (std::size_t n = 1; n < plan.module_layers.size(); ++n) {
        if (plan.module_layers[n] == 0) continue;
        const DerivedModule& module = problem.tree.nodes[n];
        const std::vector<int>& address = problem.leaves[static_cast<std::size_t>(module.leaf)].address;
        exceptions.push_back({{address.begin(), address.begin() + module.address_length},
                              problem.tree.sites[static_cast<std::size_t>(module.site)],
                              plan.module_layers[n]});
    }
    return with_layers(problem.grammar, sites, exceptions);
}

bool paints_in_order(const Grammar& grammar, const Problem& problem) {
    const std::vector<Placement> painted = interpret(grammar);
    if (painted.size() != problem.leaves.size()) return false;
    std::vector<int> position(painted.size());
    for (std::size_t k = 0; k < painted.size(); ++k)
        position[static_cast<std::size_t>(painted[k].order)] = static_cast<int>(k);
    return std::all_of(problem.pairs.begin(), problem.pairs.end(),
                       [&](const LeafPair& pair) { return at(position, pair.lower) < at(position, pair.upper); });
}

struct LayeredGrammar {
    Grammar grammar;
    std::size_t cost = 0;
};

/// By the cheapest plan that works.
LayeredGrammar layered(const Problem& problem) {
    if (paints_in_order(problem.grammar, problem)) return {problem.grammar, 0};
    for (const Plan& plan : plans_by_cost(problem)) {
        Grammar ordered = written(problem, plan);
        if (paints_in_order(ordered, problem)) return {std::move(ordered), plan.cost};
    }
    assert(false && "a leaf can always be raised by an exception of its own");
    return {problem.grammar, 0};
}

std::size_t modules_in_productions(const Grammar& grammar) {
    std::size_t modules = 0;
    for (const Production& production : grammar.productions) modules += production.successor.size();
    return modules;
}

}  // namespace

Grammar with_paint_order(const Grammar& grammar, const std::vector<int>& element_of_leaf, const Overlaps& overlaps) {
    const Problem problem = state_problem(grammar, element_of_leaf, overlaps);
    LayeredGrammar ordered = layered(problem);
    if (ordered.cost == 0) return std::move(ordered.grammar);
    // The same with layers that rise along sequences.
    const Grammar rising = with_repetition_layers(grammar, problem.leaves, problem.tree, problem.pairs);
    const std::size_t commands = modules_in_productions(rising) - modules_in_productions(grammar);
    if (commands == 0 || commands >= ordered.cost) return std::move(ordered.grammar);
    LayeredGrammar other = layered(state_problem(rising, element_of_leaf, overlaps));
    return std::move(other.cost + commands < ordered.cost ? other.grammar : ordered.grammar);
}

}  // namespace rinceau
