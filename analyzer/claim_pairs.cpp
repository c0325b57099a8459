#include "analyzer/claim_pairs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace rinceau {

namespace {

/// Candidates in the order of claiming; those whose items are free.
std::vector<std::size_t> chosen_in_order(const RuleSet& rules, const std::vector<PairCandidate>& candidates,
                                         const std::vector<std::size_t>& order) {
    std::vector<char> used(rules.items.size(), 0);
    std::vector<std::size_t> chosen;
    for (const std::size_t c : order) {
        char& first = used[static_cast<std::size_t>(candidates[c].pair.items[0])];
        char& second = used[static_cast<std::size_t>(candidates[c].pair.items[1])];
        if (first || second) continue;
        first = second = 1;
        chosen.push_back(c);
    }
    return chosen;
}

/// Which way the second lies from the first, in degrees.
int direction_of(const PairCandidate& candidate) {
    const Point way = candidate.pair.frames[1].translation - candidate.pair.frames[0].translation;
    return (static_cast<int>(std::lround(degrees(arg(way)))) + 360) % 360;
}

}  // namespace

std::vector<Chain> claimed_pairs(const RuleSet& rules, std::vector<PairCandidate> candidates, double& ambiguity) {
    std::ranges::stable_sort(candidates, {}, &PairCandidate::shift);
    if (candidates.empty()) return {};
    const auto made_by_rule = [&](int item) {
        return rules.parts[static_cast<std::size_t>(rules.items[static_cast<std::size_t>(item)].part)].rule >= 0;
    };
    const bool groups = made_by_rule(candidates[0].pair.items[0]) && made_by_rule(candidates[0].pair.items[1]);
    std::vector<std::size_t> order(candidates.size());
    std::set<std::pair<int, int>> choices;
    std::map<int, int> by_direction;
    for (std::size_t c = 0; c < order.size(); ++c) {
        order[c] = c;
        const bool fresh = choices.insert({candidates[c].pair.items[0], candidates[c].pair.items[1]}).second;
        if (fresh) ++by_direction[direction_of(candidates[c])];
    }
    auto choice = static_cast<double>(choices.size());
    std::vector<std::size_t> chosen = chosen_in_order(rules, candidates, order);
    if (chosen.size() < choices.size() && by_direction.size() > 1) {
        std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
            const int x = direction_of(candidates[a]), y = direction_of(candidates[b]);
            return std::pair{-by_direction[x], x} < std::pair{-by_direction[y], y};
        });
        std::vector<std::size_t> aligned = chosen_in_order(rules, candidates, order);
        if (aligned.size() >= chosen.size()) {
            chosen = std::move(aligned);
            // Of groups, rows and the like are found already: one direction leaves no choice.
            if (groups) choice = std::max(static_cast<double>(chosen.size()), static_cast<double>(by_direction[direction_of(candidates[order.front()])]));
        }
    }
    std::vector<Chain> pairs;
    for (const std::size_t c : chosen) pairs.push_back(std::move(candidates[c].pair));
    std::ranges::sort(pairs, {}, [](const Chain& pair) { return pair.items.front(); });
    ambiguity = choice / std::max(1.0, static_cast<double>(pairs.size()));
    return pairs;
}

}  // namespace rinceau
