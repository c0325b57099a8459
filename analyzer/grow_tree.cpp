#include "analyzer/grow_tree.h"

namespace rinceau {

std::size_t nodes_of_tree(std::size_t steps, int levels) {
    std::size_t nodes = 0, row = 1;
    for (int level = 0; level < levels; ++level) {
        nodes += row;
        row *= steps;
    }
    return nodes;
}

Similarity matched_frame(const SearchState& state, const PoseMatch& match, const Similarity& predicted) {
    const Item& item = state.item(match.item);
    const SymmetryGroup& symmetry = state.part(item.part).symmetry;
    if (!symmetry.continuous) return item.pose * symmetry.elements[static_cast<std::size_t>(match.gauge)];
    return {predicted.linear * (scale_of(item.pose) / scale_of(predicted)), item.pose.translation, predicted.mirrored};
}

void TreeGrower::set_alive(std::span<const int> items, bool alive) {
    for (const int item : items) state_->rules.items[static_cast<std::size_t>(item)].alive = alive;
}

GrownTree TreeGrower::grow(int root, const Similarity& frame, std::span<const Similarity> steps, std::size_t most_nodes) {
    GrownTree tree{1, {root}, {frame}};
    set_alive(tree.items, false);
    for (std::size_t begin = 0; tree.items.size() + (tree.items.size() - begin) * steps.size() <= most_nodes;) {
        const std::size_t end = tree.items.size();
        bool full = true;
        for (std::size_t node = begin; full && node < end; ++node) {
            for (const Similarity& step : steps) {
                const Similarity& from = tree.frames[node];
                const Similarity predicted = from * step;
                const auto match =
                    grid_->find(predicted, abs(predicted.translation - from.translation), tolerance_);
                full = match.has_value();
                if (!full) break;
                tree.items.push_back(match->item);
                tree.frames.push_back(matched_frame(*state_, *match, predicted));
                set_alive({&match->item, 1}, false);
            }
        }
        if (!full) {
            set_alive({tree.items.data() + end, tree.items.size() - end}, true);
            tree.items.resize(end);
            tree.frames.resize(end);
            break;
        }
        begin = end;
        ++tree.levels;
    }
    set_alive(tree.items, true);
    return tree;
}

void TreeGrower::claim(const GrownTree& tree) { set_alive(tree.items, false); }

}  // namespace rinceau
