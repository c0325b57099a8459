#include "analyzer/branch_opening.h"

#include <algorithm>
#include <map>

#include "analyzer/branch_items.h"
#include "analyzer/find_branching.h"
#include "analyzer/fit_branch.h"
#include "analyzer/self_similarity.h"
#include "analyzer/tree_extras.h"

namespace rinceau {

namespace {

std::vector<BranchTree> trees_of_single_items(const Branching& branching, const std::vector<int>& original) {
    std::vector<BranchTree> trees;
    for (const GrownTree& grown : branching.trees) {
        BranchTree tree{grown.levels, {}};
        for (std::size_t node = 0; node < grown.items.size(); ++node) {
            tree.nodes.push_back({grown.frames[node], {original[static_cast<std::size_t>(grown.items[node])]}});
        }
        trees.push_back(std::move(tree));
    }
    return trees;
}

/// The state with the trees as items, under the steps that fit them best.
SearchState with_trees(const SearchState& state, Rule rule, std::vector<BranchTree> trees) {
    const FittedBranch fitted = fitted_branch(state, rule, trees);
    rule.steps = fitted.steps;
    for (std::size_t t = 0; t < trees.size(); ++t) {
        trees[t].nodes.front().frame = fitted.roots[t];
        const std::size_t branches = rule.steps.size();
        for (std::size_t node = 1; node < trees[t].nodes.size(); ++node) {
            trees[t].nodes[node].frame = trees[t].nodes[(node - 1) / branches].frame * rule.steps[(node - 1) % branches];
        }
    }
    return with_branch_items(state, rule, trees);
}

/// Parts of looks, those of one outline together, and then all others.
std::vector<std::vector<int>> parts_by_shape(const SearchState& state) {
    std::map<int, std::vector<int>> by_shape;
    std::vector<std::vector<int>> groups;
    for (std::size_t p = 0; p < state.rules.parts.size(); ++p) {
        const Part& part = state.rules.parts[p];
        if (state.members[p].empty()) continue;
        if (part.shape < 0) {
            groups.push_back({static_cast<int>(p)});
        } else {
            by_shape[part.shape].push_back(static_cast<int>(p));
        }
    }
    for (auto& [shape, parts] : by_shape) groups.push_back(std::move(parts));
    std::ranges::sort(groups);
    return groups;
}

/// A state with nothing but the items of these parts, as if they were of one part.
struct Excerpt {
    SearchState state;
    std::vector<int> original;  ///< number of each item in the whole state
};

Excerpt excerpt_of(const SearchState& state, const std::vector<int>& parts) {
    Excerpt excerpt;
    for (const int part : parts) {
        const std::vector<int>& members = state.alive(part);
        excerpt.original.insert(excerpt.original.end(), members.begin(), members.end());
    }
    std::ranges::sort(excerpt.original);
    excerpt.state.tolerance = state.tolerance;
    excerpt.state.diagonal = state.diagonal;
    excerpt.state.neighbour_distance = state.neighbour_distance;
    excerpt.state.rules.parts = {state.part(parts.front())};
    excerpt.state.members.resize(1);
    for (const int item : excerpt.original) {
        excerpt.state.members[0].push_back(static_cast<int>(excerpt.state.rules.items.size()));
        excerpt.state.rules.items.push_back(state.item(item));
        excerpt.state.rules.items.back().part = 0;
    }
    refresh(excerpt.state, {0});
    return excerpt;
}

/// Does each level of the trees consist of one part?
bool even_levels(const SearchState& state, const std::vector<BranchTree>& trees, std::size_t branches) {
    std::map<int, int> part_of_depth;
    for (const BranchTree& tree : trees) {
        std::size_t node = 0;
        for (int depth = tree.depth; depth > 0; --depth) {
            for (const std::size_t end = nodes_of_tree(branches, tree.depth - depth + 1); node < end; ++node) {
                const int part = state.item(tree.nodes[node].items.front()).part;
                if (part_of_depth.try_emplace(depth, part).first->second != part) return false;
            }
        }
    }
    return true;
}

/// Trees of the items of these parts become items in `opened`, which begins as `start`.
bool grow_trees(const SearchState& start, const std::vector<int>& parts, std::optional<SearchState>& opened) {
    const SearchState& state = opened ? *opened : start;
    std::size_t items = 0;
    for (const int part : parts) items += state.alive(part).size();
    if (items < fewest_items_of_tree) return false;
    Excerpt excerpt = excerpt_of(state, parts);
    const auto branching = find_branching(excerpt.state, 0);
    if (!branching) return false;
    TreesOfRule found{{}, trees_of_single_items(*branching, excerpt.original)};
    if (parts.size() > 1 && !even_levels(state, found.trees, branching->steps.size())) return false;
    found.rule.kind = RuleKind::branch;
    found.rule.members = {{state.item(found.trees.front().nodes.front().items.front()).part, {}}};
    found.rule.steps = branching->steps;
    found = with_extras(state, std::move(found));
    opened = with_trees(state, std::move(found.rule), std::move(found.trees));
    return true;
}

/// Items that stand for several copies in one place (see starting_state), by the part of the copies.
std::map<int, std::vector<int>> stacks_by_part(const SearchState& start) {
    std::map<int, std::vector<int>> stacks;
    for (std::size_t p = 0; p < start.rules.parts.size(); ++p) {
        if (start.rules.parts[p].rule < 0) continue;
        for (const int item : start.members[p]) stacks[start.item(start.item(item).members.front()).part].push_back(item);
    }
    return stacks;
}

/// Curves that touch themselves draw some pieces twice: here each copy is an item.
SearchState without_stacks(SearchState state, int part, const std::vector<int>& stacks) {
    std::vector<int> touched{part};
    for (const int stack : stacks) {
        Item& item = state.rules.items[static_cast<std::size_t>(stack)];
        item.alive = false;
        touched.push_back(item.part);
        for (const int copy : item.members) {
            state.rules.items[static_cast<std::size_t>(copy)].alive = true;
            state.members[static_cast<std::size_t>(part)].push_back(copy);
        }
    }
    std::ranges::sort(state.members[static_cast<std::size_t>(part)]);
    std::ranges::sort(touched);
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    refresh(state, touched);
    return state;
}

}  // namespace

std::optional<SearchState> open_with_branching(const SearchState& start) {
    std::optional<SearchState> opened;
    for (const std::vector<int>& parts : parts_by_shape(start)) {
        bool found = false;
        if (parts.size() > 1) found = grow_trees(start, parts, opened);
        for (const int part : parts) found = found || grow_trees(start, {part}, opened);
    }
    return opened;
}

std::optional<SearchState> open_with_self_similarity(const SearchState& start) {
    std::optional<SearchState> opened;
    const std::map<int, std::vector<int>> stacks = stacks_by_part(start);
    const auto parts = static_cast<int>(start.rules.parts.size());
    for (int part = 0; part < parts; ++part) {
        const auto stacked = stacks.find(part);
        std::optional<SearchState> apart;
        if (stacked != stacks.end()) apart = without_stacks(opened ? *opened : start, part, stacked->second);
        const SearchState& state = apart ? *apart : opened ? *opened : start;
        const auto found = find_self_similarity(state, part);
        if (found) opened = with_trees(state, found->rule, found->trees);
    }
    return opened;
}

}  // namespace rinceau
