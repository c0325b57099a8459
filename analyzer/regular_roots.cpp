#include "analyzer/regular_roots.h"

#include <vector>

#include "analyzer/regauge.h"
#include "analyzer/regular_drawing.h"

namespace rinceau {

namespace {

/// Moves the item and all that is below it.
void move_item(RuleSet& rules, int item, const Similarity& motion) {
    Item& at = rules.items[static_cast<std::size_t>(item)];
    at.pose = motion * at.pose;
    for (const int member : at.members) {
        if (member >= 0) move_item(rules, member, motion);
    }
}

bool is_verbatim(const RuleSet& rules, const Instancing& instancing, int item) {
    const int look = rules.parts[static_cast<std::size_t>(rules.items[static_cast<std::size_t>(item)].part)].look;
    return look >= 0 && !instancing.looks[static_cast<std::size_t>(look)].verbatim.empty();
}

/// Roots and how the regular drawing moves them.
struct MovedRoots {
    std::vector<int> roots;
    std::vector<Similarity> motions;
};

std::optional<MovedRoots> regular_motions(const RuleSet& rules, const Instancing& instancing, double diagonal) {
    MovedRoots moved;
    std::vector<PlacedCopy> copies;
    for (const int root : root_items(rules)) {
        if (is_verbatim(rules, instancing, root)) continue;
        const Item& item = rules.items[static_cast<std::size_t>(root)];
        copies.push_back({item.part, item.pose, &rules.parts[static_cast<std::size_t>(item.part)].symmetry});
        moved.roots.push_back(root);
    }
    bool any = false;
    const std::vector<Similarity> regular = regular_poses(copies, diagonal);
    for (std::size_t c = 0; c < copies.size(); ++c) {
        const Part& part = rules.parts[static_cast<std::size_t>(copies[c].kind)];
        moved.motions.push_back(nearest_pose(part, regular[c], copies[c].pose) * inverse(copies[c].pose));
        any = any || stands_elsewhere(copies[c].pose, regular[c]);
    }
    return any ? std::optional(std::move(moved)) : std::nullopt;
}

/// The search stands where these rules are found already.
SearchState state_of(RuleSet rules, const Drawing& drawing, double tolerance) {
    SearchState state =
        starting_state(drawing.instancing, {tolerance, tolerance, PoseTolerance{}.per_distance}, drawing.diagonal);
    state.rules = std::move(rules);
    state.members.assign(state.rules.parts.size(), {});
    std::vector<int> all;
    for (std::size_t p = 0; p < state.rules.parts.size(); ++p) all.push_back(static_cast<int>(p));
    for (std::size_t i = 0; i < state.rules.items.size(); ++i) {
        const auto item = static_cast<int>(i);
        if (!state.item(item).alive || is_verbatim(state.rules, drawing.instancing, item)) continue;
        state.members[static_cast<std::size_t>(state.item(item).part)].push_back(item);
    }
    refresh(state, all);
    return state;
}

}  // namespace

std::optional<Description> with_regular_roots(const Description& exact, const SearchOptions& search,
                                              const Progress& progress) {
    const Drawing& drawing = *exact.reading;
    RuleSet rules = exact.ordered.rules;
    const std::optional<MovedRoots> moved = regular_motions(rules, drawing.instancing, drawing.diagonal);
    if (!moved) return std::nullopt;
    for (std::size_t r = 0; r < moved->roots.size(); ++r) move_item(rules, moved->roots[r], moved->motions[r]);
    const std::size_t rules_before = rules.rules.size();
    constexpr double size = PoseTolerance{}.size;
    SearchState found = generate_rules(state_of(std::move(rules), drawing, size), search, progress);
    if (found.rules.rules.size() == rules_before) return std::nullopt;
    for (std::size_t r = 0; r < moved->roots.size(); ++r) {
        // What no rule has taken stands where it is drawn.
        if (found.item(moved->roots[r]).alive) move_item(found.rules, moved->roots[r], inverse(moved->motions[r]));
    }
    return describe(drawing, std::move(found.rules), size);
}

}  // namespace rinceau
