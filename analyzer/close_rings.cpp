#include "analyzer/close_rings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "analyzer/fit_step.h"
#include "analyzer/gather.h"
#include "analyzer/regauge.h"

namespace rinceau {

namespace {

constexpr int smallest_ring = 6;
constexpr int large_ring = 12;  // from here on two neighbours may be missing

const Rule& rule_of(const SearchState& state, int item) {
    return state.rules.rules[static_cast<std::size_t>(state.part(state.item(item).part).rule)];
}

/// How a sequence fits into a ring.
struct RingPlan {
    int count = 0;
    std::vector<int> members;  ///< for each place of the ring; -1: missing
    Chain chain;               ///< those that the rule must fit
    Similarity first;          ///< frame of the first place
};

/// Are the gaps of the ring few and short?
bool few_gaps(const std::vector<int>& items) {
    const auto count = static_cast<int>(items.size());
    const auto missing = static_cast<int>(std::ranges::count(items, -1));
    const int longest = count >= large_ring ? 2 : 1;
    int gap = 0;
    for (int k = 0; k < 2 * count; ++k) {  // twice round: a gap may span the beginning
        gap = items[static_cast<std::size_t>(k % count)] < 0 ? gap + 1 : 0;
        if (gap > longest) return false;
    }
    return missing > 0 && 3 * missing <= count;
}

std::optional<RingPlan> ring_of(const SearchState& state, int i) {
    const Item& item = state.item(i);
    const Part& part = state.part(item.part);
    const Rule& rule = rule_of(state, i);
    const auto present = static_cast<int>(item.members.size());
    const double turn = arg(rule.step.linear);
    const double allowed = state.tolerance.turn(state.part(rule.repeated).radius);
    if (rule.step.mirrored || abs(rule.step.translation) <= state.tolerance.size) return std::nullopt;
    for (int count = std::max(smallest_ring, present + 1); 2 * count <= 3 * present; ++count) {
        const bool closes = std::abs(wrap_angle(count * turn)) <= allowed &&
                            std::abs(std::log(scale_of(rule.step))) * count <= allowed;
        if (!closes) continue;
        RingPlan plan{count, std::vector<int>(static_cast<std::size_t>(count), -1), {}, item.pose * part.children.front().pose};
        plan.chain.items = plan.members;
        plan.chain.frames.resize(plan.members.size());
        const auto stride = static_cast<int>(std::lround(count * turn / two_pi));
        for (std::size_t k = 0; k < item.members.size(); ++k) {
            const auto place = static_cast<std::size_t>(((static_cast<int>(k) * stride) % count + count) % count);
            plan.members[place] = item.members[k];
            if (!is_regular(state.rules, item, k)) continue;
            plan.chain.items[place] = item.members[k];
            plan.chain.frames[place] =
                nearest_pose(state.part(rule.repeated), state.item(item.members[k]).pose, item.pose * part.children[k].pose);
        }
        return few_gaps(plan.members) ? std::optional(plan) : std::nullopt;
    }
    return std::nullopt;
}

/// The rule of the ring, about the pivot of the sequence's step.
Rule ring_rule(const SearchState& state, const Rule& sequence, const RingPlan& plan) {
    Rule rule = sequence;
    rule.kind = RuleKind::ring;
    const Point pivot = sequence.step.translation / (Complex{1, 0} - sequence.step.linear);
    rule.step.linear = polar(1, two_pi / plan.count);
    rule.step.translation = pivot - rule.step.linear * pivot;
    return fitted(rule, std::span(&plan.chain, 1), std::max(1.0, state.part(rule.repeated).radius));
}

Point pivot_of(const Rule& rule) { return rule.step.translation / (Complex{1, 0} - rule.step.linear); }

/// A part for the ring, and how many places on its next member stands.
struct RingPart {
    int part = 0;
    int stride = 1;
};

/// The part of an equal ring, which may run the other way or leap, or a new one.
RingPart ring_part(SearchState& state, const Rule& rule, int count) {
    const Point pivot = pivot_of(rule);
    for (std::size_t p = 0; p < state.rules.parts.size(); ++p) {
        const Part& part = state.rules.parts[p];
        if (part.rule < 0 || part.count != count) continue;
        const Rule& other = state.rules.rules[static_cast<std::size_t>(part.rule)];
        const bool alike = other.kind == RuleKind::ring && other.repeated == rule.repeated && !other.step.mirrored &&
                           abs(pivot_of(other) - pivot) <= guard_slack * state.tolerance.shift(1, abs(pivot));
        if (!alike) continue;
        const auto places = static_cast<int>(std::lround(arg(other.step.linear) * count / two_pi));
        return {static_cast<int>(p), ((places % count) + count) % count};
    }
    state.rules.rules.push_back(rule);
    return {part_of_count(state, static_cast<int>(state.rules.rules.size()) - 1, count), 1};
}

}  // namespace

void close_rings(SearchState& state, GridCache& grids, Substitution& made) {
    std::set<int> touched(made.touched_parts.begin(), made.touched_parts.end());
    std::vector<int> items;
    for (const int i : made.new_items) {
        items.push_back(i);
        if (rule_of(state, i).kind != RuleKind::sequence) continue;
        const auto ring = ring_of(state, i);
        if (!ring) continue;
        const auto [part, stride] = ring_part(state, ring_rule(state, rule_of(state, i), *ring), ring->count);
        Gathered plan;
        for (int k = 0; k < ring->count; ++k) {
            plan.members.push_back({ring->members[static_cast<std::size_t>(k * stride % ring->count)], {}, {}, 0});
        }
        plan.runs = {i};
        const Similarity pose = ring->first * inverse(state.part(part).children.front().pose);
        std::set<int> parts;
        const int whole = make_item(state, part, plan, pose, parts);
        for (const int p : parts) grids.forget(p);
        refresh(state, {parts.begin(), parts.end()});
        touched.insert(parts.begin(), parts.end());
        if (whole >= 0) items.back() = whole;
    }
    made.new_items = std::move(items);
    made.touched_parts.assign(touched.begin(), touched.end());
}

}  // namespace rinceau
