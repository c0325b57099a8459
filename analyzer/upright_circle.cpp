#include "analyzer/upright_circle.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "analyzer/regauge.h"

namespace rinceau {

namespace {

constexpr std::size_t least_members = 5;

const Item& item_at(const RuleSet& rules, int item) { return rules.items[static_cast<std::size_t>(item)]; }

/// Goes on from the first two items, as long as there is one at the next place, until one comes again.
void follow(Chain& chain, const RuleSet& rules, const PoseGrid& grid, double turn_change, const PoseTolerance& tolerance) {
    const Part& part = rules.parts[static_cast<std::size_t>(grid.part())];
    const Point first_way = chain.frames[1].translation - chain.frames[0].translation;
    const double sense = chain.frames[0].mirrored ? -1 : 1;
    std::set<int> seen(chain.items.begin(), chain.items.end());
    for (;;) {
        const auto steps = static_cast<double>(chain.items.size()) - 1;
        Similarity predicted = chain.frames.front();
        predicted.translation = chain.frames.back().translation + Point(first_way * polar(1, sense * steps * turn_change));
        const auto match = grid.find(predicted, abs(first_way), tolerance);
        if (!match) return;
        if (!seen.insert(match->item).second) {
            chain.closed = match->item == chain.items.front();
            return;
        }
        chain.items.push_back(match->item);
        chain.frames.push_back(item_at(rules, match->item).pose *
                               part.symmetry.elements[static_cast<std::size_t>(match->gauge)]);
    }
}

void begin_at(Chain& chain, std::ptrdiff_t first) {
    std::rotate(chain.items.begin(), chain.items.begin() + first, chain.items.end());
    std::rotate(chain.frames.begin(), chain.frames.begin() + first, chain.frames.end());
}

void begin_at_lowest(const RuleSet& rules, Chain& chain) {
    const auto lowest = std::ranges::min_element(chain.items, {}, [&](int i) { return item_at(rules, i).first; });
    begin_at(chain, lowest - chain.items.begin());
}

Similarity first_step(const Chain& chain) { return inverse(chain.frames[0]) * chain.frames[1]; }

/// Turns the ring, and its members by their symmetry, so that it begins with a step like `wanted`; as near as it can.
void begin_alike(const Part& part, Chain& chain, const Similarity& wanted) {
    double least = HUGE_VAL;
    std::ptrdiff_t begin = 0;
    Similarity turned;
    for (std::size_t k = 0; k < chain.items.size(); ++k) {
        const Similarity step = inverse(chain.frames[k]) * chain.frames[(k + 1) % chain.frames.size()];
        for (const Similarity& gauge : part.symmetry.elements) {
            const double off = abs((inverse(gauge) * step * gauge).translation - wanted.translation);
            if (gauge.mirrored || off >= least) continue;
            least = off;
            begin = static_cast<std::ptrdiff_t>(k);
            turned = gauge;
        }
    }
    begin_at(chain, begin);
    for (Similarity& frame : chain.frames) frame = frame * turned;
}

}  // namespace

std::vector<LinearChain> upright_chains(const RuleSet& rules, const PoseGrid& grid,
                                        std::span<const std::pair<int, int>> starts, double turn_change,
                                        const PoseTolerance& tolerance) {
    const Part& part = rules.parts[static_cast<std::size_t>(grid.part())];
    std::vector<LinearChain> chains;
    std::set<std::pair<int, int>> covered;
    for (const auto& [from, to] : starts) {
        if (covered.contains({from, to}) || !item_at(rules, from).alive || !item_at(rules, to).alive) continue;
        Chain chain;
        chain.items = {from, to};
        chain.frames = {item_at(rules, from).pose, nearest_pose(part, item_at(rules, to).pose, item_at(rules, from).pose)};
        follow(chain, rules, grid, turn_change, tolerance);
        if (chain.items.size() < least_members) continue;
        for (std::size_t k = 0; k + 1 < chain.items.size(); ++k) covered.insert({chain.items[k], chain.items[k + 1]});
        if (chain.closed) {
            covered.insert({chain.items.back(), chain.items.front()});
            begin_at_lowest(rules, chain);
        }
        chains.push_back({chain, {}});
    }
    if (chains.empty()) return chains;
    const auto longest = std::ranges::max_element(chains, {}, [](const LinearChain& c) { return c.chain.items.size(); });
    const Similarity wanted = first_step(longest->chain);
    for (LinearChain& each : chains) {
        if (each.chain.closed && &each != &*longest) begin_alike(part, each.chain, wanted);
        each.first_step = first_step(each.chain);
    }
    return chains;
}

Point circle_centre(const Rule& rule) { return Point(rule.step.translation / (Complex{1, 0} - polar(1, rule.turn_change))); }

bool comes_round(const Rule& rule, int count) {
    constexpr double rounding = 1e-9;
    return std::abs(std::abs(rule.turn_change) * count - two_pi) < rounding;
}

}  // namespace rinceau
