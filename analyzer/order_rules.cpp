#include "analyzer/order_rules.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <set>

#include "analyzer/regauge.h"

namespace rinceau {

namespace {

/// Where an item stands in the item above it.
struct Place {
    int above = -1;
    int index = 0;
};

std::vector<Place> places_of(const RuleSet& rules) {
    std::vector<Place> places(rules.items.size());
    for (std::size_t i = 0; i < rules.items.size(); ++i) {
        const std::vector<int>& members = rules.items[i].members;
        for (std::size_t k = 0; k < members.size(); ++k) {
            if (members[k] >= 0) places[static_cast<std::size_t>(members[k])] = {static_cast<int>(i), static_cast<int>(k)};
        }
    }
    return places;
}

/// The items from an element up to its root.
std::vector<int> way_up(const std::vector<Place>& places, int item) {
    std::vector<int> way;
    for (; item >= 0; item = places[static_cast<std::size_t>(item)].above) way.push_back(item);
    return way;
}

/// How often member i of a part must lie below member j; for roots the items themselves.
struct Votes {
    std::map<int, std::map<std::pair<int, int>, double>> by_part;
    std::map<std::pair<int, int>, double> roots;
};

constexpr double faint_vote = 1e-3;  // of pairs whose order hardly shows

Votes overlap_votes(const RuleSet& rules, const Overlaps& overlaps, const std::vector<Place>& places) {
    std::map<int, int> item_of_element;
    for (std::size_t i = 0; i < rules.items.size(); ++i) {
        if (rules.items[i].element >= 0) item_of_element[rules.items[i].element] = static_cast<int>(i);
    }
    Votes votes;
    const auto vote = [&](const OverlapPair& pair, double weight) {
        const auto lower = item_of_element.find(pair.lower), upper = item_of_element.find(pair.upper);
        if (lower == item_of_element.end() || upper == item_of_element.end()) return;
        const std::vector<int> a = way_up(places, lower->second), b = way_up(places, upper->second);
        // From the root down to where the ways part.
        std::size_t shared = 0;
        while (shared < a.size() && shared < b.size() && a[a.size() - 1 - shared] == b[b.size() - 1 - shared]) ++shared;
        const int below = a[a.size() - 1 - shared], over = b[b.size() - 1 - shared];
        if (shared == 0) {
            votes.roots[{below, over}] += weight;
            return;
        }
        const Item& parent = rules.items[static_cast<std::size_t>(a[a.size() - shared])];
        votes.by_part[parent.part][{places[static_cast<std::size_t>(below)].index,
                                    places[static_cast<std::size_t>(over)].index}] += weight;
    };
    for (const OverlapPair& pair : overlaps.pairs) vote(pair, 1);
    for (const OverlapPair& pair : overlaps.faint) vote(pair, faint_vote);
    return votes;
}

constexpr double drawing_order_vote = 1e-6;  // decides only where nothing overlaps

/// Adds faint votes for the order in which the drawing lists the members.
void add_drawing_order(const RuleSet& rules, Votes& votes) {
    for (const Item& item : rules.items) {
        if (item.members.size() < 2) continue;
        auto& part_votes = votes.by_part[item.part];
        for (std::size_t k = 0; k + 1 < item.members.size(); ++k) {
            if (item.members[k] < 0 || item.members[k + 1] < 0) continue;
            const bool rising = rules.items[static_cast<std::size_t>(item.members[k])].first <
                                rules.items[static_cast<std::size_t>(item.members[k + 1])].first;
            const int i = static_cast<int>(rising ? k : k + 1), j = static_cast<int>(rising ? k + 1 : k);
            part_votes[{i, j}] += drawing_order_vote;
        }
    }
}

double balance(const std::map<std::pair<int, int>, double>& votes) {
    double sum = 0;
    for (const auto& [pair, weight] : votes) sum += pair.first < pair.second ? weight : -weight;
    return sum;
}

/// An order of 0..count-1 that follows as many votes as a greedy choice can, lowest `key` first among free ones.
std::vector<int> voted_order(int count, const std::map<std::pair<int, int>, double>& votes, const std::vector<int>& key) {
    std::vector<std::set<int>> below(static_cast<std::size_t>(count));
    std::vector<std::vector<int>> above(static_cast<std::size_t>(count));
    for (const auto& [pair, weight] : votes) {
        const auto opposite = votes.find({pair.second, pair.first});
        if (opposite != votes.end() && opposite->second >= weight) continue;
        below[static_cast<std::size_t>(pair.second)].insert(pair.first);
        above[static_cast<std::size_t>(pair.first)].push_back(pair.second);
    }
    std::vector<int> order;
    std::vector<char> placed(static_cast<std::size_t>(count), 0);
    using Entry = std::pair<int, int>;  // (key, index), lowest first
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> free;
    std::set<Entry> waiting;
    for (int k = 0; k < count; ++k) {
        const Entry entry{key[static_cast<std::size_t>(k)], k};
        waiting.insert(entry);
        if (below[static_cast<std::size_t>(k)].empty()) free.push(entry);
    }
    while (!waiting.empty()) {
        if (free.empty()) free.push(*waiting.begin());  // a cycle: the lowest goes first, layers mend the rest
        const int k = free.top().second;
        waiting.erase(free.top());
        free.pop();
        if (placed[static_cast<std::size_t>(k)]) continue;
        placed[static_cast<std::size_t>(k)] = 1;
        order.push_back(k);
        for (const int j : above[static_cast<std::size_t>(k)]) {
            auto& waits = below[static_cast<std::size_t>(j)];
            waits.erase(k);
            if (waits.empty() && !placed[static_cast<std::size_t>(j)]) free.push({key[static_cast<std::size_t>(j)], j});
        }
    }
    return order;
}

/// Sequences and rings of these rules run the other way.
void reverse_rule(RuleSet& rules, int rule_index) {
    Rule& rule = rules.rules[static_cast<std::size_t>(rule_index)];
    rule.step = inverse(rule.step);
    if (rule.kind == RuleKind::spiral) {
        const auto part = std::ranges::find(rules.parts, rule_index, &Part::rule);
        rule.spiral.start = spiral_index(rule.spiral, part->count - 1);
        rule.spiral.direction = -rule.spiral.direction;
    }
    const bool ring = rule.kind == RuleKind::ring;
    const auto reverse = [&](auto& list) { std::reverse(list.begin() + (ring ? 1 : 0), list.end()); };
    for (std::size_t p = 0; p < rules.parts.size(); ++p) {
        if (rules.parts[p].rule == rule_index) reverse(rules.parts[p].children);
    }
    for (Item& item : rules.items) {
        if (rules.parts[static_cast<std::size_t>(item.part)].rule == rule_index) reverse(item.members);
    }
}

void reorder_group(RuleSet& rules, int part_index, const std::vector<int>& order) {
    Part& part = rules.parts[static_cast<std::size_t>(part_index)];
    const std::vector<Child> children = part.children;
    for (std::size_t k = 0; k < order.size(); ++k) part.children[k] = children[static_cast<std::size_t>(order[k])];
    for (Item& item : rules.items) {
        if (item.part != part_index) continue;
        const std::vector<int> members = item.members;
        for (std::size_t k = 0; k < order.size(); ++k) item.members[k] = members[static_cast<std::size_t>(order[k])];
    }
    Rule& rule = rules.rules[static_cast<std::size_t>(part.rule)];
    rule.members.clear();
    const Similarity to_first = inverse(part.children.front().pose);
    for (const Child& child : part.children) rule.members.push_back({child.part, to_first * child.pose});
}

/// Roots stand unmirrored and as upright as their symmetry allows.
void settle_roots(RuleSet& rules) {
    constexpr double clearly = 1e-6;  // radians: equivalent poses that differ by rounding only are not exchanged
    for (const int root : root_items(rules)) {
        const Item& item = rules.items[static_cast<std::size_t>(root)];
        const Part& part = rules.parts[static_cast<std::size_t>(item.part)];
        if (part.look >= 0 || part.symmetry.continuous) continue;
        Similarity best = item.pose;
        const auto tilt = [](const Similarity& pose) { return std::abs(arg(pose.linear)) + (pose.mirrored ? two_pi : 0); };
        for (const Similarity& gauge : part.symmetry.elements) {
            if (tilt(item.pose * gauge) < tilt(best) - clearly) best = item.pose * gauge;
        }
        regauge(rules, root, best);
    }
}

}  // namespace

OrderedRules ordered_for_painting(RuleSet rules, const Overlaps& overlaps) {
    settle_roots(rules);
    const std::vector<Place> places = places_of(rules);
    Votes votes = overlap_votes(rules, overlaps, places);
    add_drawing_order(rules, votes);

    // Direction of sequences and rings: over all parts of the rule.
    std::map<int, double> forward;
    for (const auto& [part, part_votes] : votes.by_part) {
        const int rule = rules.parts[static_cast<std::size_t>(part)].rule;
        const RuleKind kind = rules.rules[static_cast<std::size_t>(rule)].kind;
        if (kind == RuleKind::sequence || kind == RuleKind::ring || kind == RuleKind::spiral ||
            kind == RuleKind::family) {
            forward[rule] += balance(part_votes);
        } else if (kind == RuleKind::group) {
            std::vector<int> key(rules.parts[static_cast<std::size_t>(part)].children.size());
            for (std::size_t k = 0; k < key.size(); ++k) key[k] = static_cast<int>(k);
            reorder_group(rules, part, voted_order(static_cast<int>(key.size()), part_votes, key));
        }
    }
    for (const auto& [rule, sum] : forward) {
        if (sum < 0) reverse_rule(rules, rule);
    }

    // The axiom: roots by what lies below what.
    OrderedRules ordered;
    const std::vector<int> roots = root_items(rules);
    std::map<int, int> slot;
    for (std::size_t k = 0; k < roots.size(); ++k) slot[roots[k]] = static_cast<int>(k);
    std::map<std::pair<int, int>, double> root_votes;
    for (const auto& [pair, weight] : votes.roots) root_votes[{slot[pair.first], slot[pair.second]}] += weight;
    std::vector<int> key(roots.size());
    for (std::size_t k = 0; k < roots.size(); ++k) key[k] = static_cast<int>(k);
    for (const int k : voted_order(static_cast<int>(roots.size()), root_votes, key)) {
        ordered.roots.push_back(roots[static_cast<std::size_t>(k)]);
    }
    ordered.rules = std::move(rules);
    return ordered;
}

}  // namespace rinceau
