// docs/analysis.md, 4.2: which chain gets an item that several could have.

#include <algorithm>
#include <cmath>
#include <map>

#include "analyzer/chains.h"

namespace rinceau {

namespace {

const Item& item_at(const RuleSet& rules, int item) { return rules.items[static_cast<std::size_t>(item)]; }

/// What decides between chains, computed once each.
struct Precedence {
    std::size_t length = 0;
    bool closed = false, rising = false;
    int gauge = 0, first = 0;
    std::size_t index = 0;

    bool before(const Precedence& other) const {
        if (length != other.length) return length > other.length;
        if (closed != other.closed) return closed;
        if (rising != other.rising) return rising;
        if (gauge != other.gauge) return gauge < other.gauge;
        if (first != other.first) return first < other.first;
        return index < other.index;
    }
};

Precedence precedence_of(const RuleSet& rules, const Chain& chain, std::size_t index) {
    int balance = 0;
    for (std::size_t k = 0; k + 1 < chain.items.size(); ++k) {
        balance += item_at(rules, chain.items[k]).first < item_at(rules, chain.items[k + 1]).first ? 1 : -1;
    }
    return {chain.items.size(), chain.closed, balance > 0, chain.gauge, item_at(rules, chain.items.front()).first, index};
}

}  // namespace

namespace {

/// Disjoint chains in this order of claiming, and what it cost.
struct Claim {
    std::vector<Chain> chains;
    std::size_t links = 0;
    std::size_t cut = 0;  ///< chains that got only a run of themselves
};

Claim claim_in_order(const RuleSet& rules, const std::vector<Chain>& chains, const std::vector<Precedence>& order) {
    const bool long_ones = std::ranges::any_of(order, [](const Precedence& p) { return p.length >= 4; });
    const std::size_t least = long_ones ? 3 : 2;
    std::vector<char> used(rules.items.size(), 0);
    Claim claim;
    for (const Precedence& next : order) {
        if (next.length < least) continue;
        const Chain& chain = chains[next.index];
        // The longest run of free items.
        std::size_t best_begin = 0, best_length = 0, begin = 0;
        for (std::size_t k = 0; k <= chain.items.size(); ++k) {
            if (k < chain.items.size() && !used[static_cast<std::size_t>(chain.items[k])]) continue;
            if (k - begin > best_length) {
                best_length = k - begin;
                best_begin = begin;
            }
            begin = k + 1;
        }
        if (best_length < least) continue;
        claim.chains.push_back(chain);
        Chain& claimed = claim.chains.back();
        if (best_length < chain.items.size()) {
            const auto from = static_cast<std::ptrdiff_t>(best_begin);
            const auto to = from + static_cast<std::ptrdiff_t>(best_length);
            claimed.items = {chain.items.begin() + from, chain.items.begin() + to};
            claimed.frames = {chain.frames.begin() + from, chain.frames.begin() + to};
            claimed.closed = false;
            ++claim.cut;
        }
        for (const int item : claimed.items) used[static_cast<std::size_t>(item)] = 1;
        claim.links += claimed.items.size() - 1;
    }
    return claim;
}

/// Which way a straight chain runs, forth and back alike, in steps of about a degree; -1 if it bends.
int direction_of(const Chain& chain) {
    constexpr double degree = pi / 180;
    const auto way = [&](std::size_t k) { return arg(chain.frames[k + 1].translation - chain.frames[k].translation); };
    const double first = way(0), last = way(chain.frames.size() - 2);
    if (std::abs(wrap_angle(last - first)) > degree) return -1;
    return (static_cast<int>(std::lround(first / degree)) + 360) % 180;
}

/// Straight chains of one direction first, that with the most links; nothing if some bend or all run the same way.
std::vector<Precedence> by_direction(const std::vector<Chain>& chains, std::vector<Precedence> order) {
    std::map<int, std::size_t> links;
    std::vector<int> directions(chains.size());
    for (const Precedence& next : order) {
        const int direction = directions[next.index] = direction_of(chains[next.index]);
        if (direction < 0) return {};
        links[direction] += next.length - 1;
    }
    if (links.size() < 2) return {};
    // Ties: as the longest chain runs.
    std::size_t most = 0;
    int leading = -1;
    for (const Precedence& next : order) {
        if (links[directions[next.index]] > most) {
            leading = directions[next.index];
            most = links[leading];
        }
    }
    std::stable_partition(order.begin(), order.end(), [&](const Precedence& next) {
        const int apart = std::abs(directions[next.index] - leading);
        return std::min(apart, 180 - apart) <= 1;
    });
    return order;
}

}  // namespace

std::vector<Chain> claimed(const RuleSet& rules, std::vector<Chain> chains) {
    std::vector<Precedence> order;
    order.reserve(chains.size());
    for (std::size_t c = 0; c < chains.size(); ++c) order.push_back(precedence_of(rules, chains[c], c));
    std::ranges::sort(order, [](const Precedence& a, const Precedence& b) { return a.before(b); });
    Claim claim = claim_in_order(rules, chains, order);
    if (claim.cut == 0) return std::move(claim.chains);
    // Rows and columns of one step (of circles, say) cut each other: perhaps they do not if all run the same way.
    const std::vector<Precedence> aligned = by_direction(chains, order);
    if (aligned.empty()) return std::move(claim.chains);
    constexpr double as_many = 0.9;  // links
    Claim other = claim_in_order(rules, chains, aligned);
    const bool better = other.cut < claim.cut && static_cast<double>(other.links) >= as_many * static_cast<double>(claim.links);
    return better ? std::move(other.chains) : std::move(claim.chains);
}

}  // namespace rinceau
