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

bool is_row(const RuleSet& rules, int item) {
    const int rule = rules.parts[static_cast<std::size_t>(rules.items[static_cast<std::size_t>(item)].part)].rule;
    return rule >= 0 && rules.rules[static_cast<std::size_t>(rule)].kind == RuleKind::sequence;
}

bool alike(int a, int b) {
    const int apart = std::abs(a - b);
    return std::min(apart, 360 - apart) <= 1;
}

/// How many lie in this direction, give or take a degree.
int about(const std::map<int, int>& by_direction, int direction) {
    int sum = 0;
    for (int d = direction + 359; d <= direction + 361; ++d) {
        const auto at = by_direction.find(d % 360);
        sum += at == by_direction.end() ? 0 : at->second;
    }
    return sum;
}

int leading_direction(const std::map<int, int>& by_direction) {
    int leading = 0, most = 0;
    for (const auto& [direction, unused] : by_direction) {
        const int sum = about(by_direction, direction);
        if (sum > most) {
            most = sum;
            leading = direction;
        }
    }
    return leading;
}

}  // namespace

std::vector<Chain> claimed_pairs(const RuleSet& rules, std::vector<PairCandidate> candidates, double& ambiguity) {
    std::ranges::stable_sort(candidates, {}, &PairCandidate::shift);
    if (candidates.empty()) return {};
    const std::vector<int>& items = candidates.front().pair.items;
    const bool rows = is_row(rules, items[0]) && is_row(rules, items[1]);
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
        const int leading = leading_direction(by_direction);
        std::stable_partition(order.begin(), order.end(),
                              [&](std::size_t c) { return alike(direction_of(candidates[c]), leading); });
        std::vector<std::size_t> aligned = chosen_in_order(rules, candidates, order);
        const bool all_alike =
            std::ranges::all_of(aligned, [&](std::size_t c) { return alike(direction_of(candidates[c]), leading); });
        if (all_alike && aligned.size() >= chosen.size()) {
            chosen = std::move(aligned);
            // Of rows, what repeats is found already: one direction leaves no choice.
            if (rows) choice = std::max(static_cast<double>(chosen.size()), static_cast<double>(about(by_direction, leading)));
        }
    }
    std::vector<Chain> pairs;
    for (const std::size_t c : chosen) pairs.push_back(std::move(candidates[c].pair));
    std::ranges::sort(pairs, {}, [](const Chain& pair) { return pair.items.front(); });
    ambiguity = choice / std::max(1.0, static_cast<double>(pairs.size()));
    return pairs;
}

}  // namespace rinceau
