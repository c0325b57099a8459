#include "analyzer/substitute.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "analyzer/fit_step.h"
#include "analyzer/group_frame.h"
#include "analyzer/regauge.h"

namespace rinceau {

namespace {

constexpr double natural_slack = 0.5;  // of the tolerance, given up for round values

double child_radius(const SearchState& state, const Hypothesis& hypothesis) {
    return std::max(1.0, state.part(hypothesis.to).radius);
}

std::vector<Similarity> child_poses(const Rule& rule, int count) {
    if (rule.kind != RuleKind::group) return centred(repetition_poses(rule, count));
    std::vector<Similarity> poses;
    for (const Child& member : rule.members) poses.push_back(member.pose);
    return centred(std::move(poses));
}

Part new_part(const SearchState& state, const Rule& rule, int rule_index, int count) {
    Part part;
    part.rule = rule_index;
    part.count = rule.kind == RuleKind::group ? 1 : count;
    const std::vector<Similarity> poses = child_poses(rule, count);
    for (std::size_t k = 0; k < poses.size(); ++k) {
        const int child = rule.kind == RuleKind::group ? rule.members[k].part : rule.repeated;
        part.children.push_back({child, poses[k]});
    }
    return completed_part(state.rules, std::move(part), guard_slack * state.tolerance.size,
                          guard_slack * state.tolerance.angle);
}

/// Where the members of a chain lie when the group stands in its best pose; false if one of them misses its place.
bool members_fit(const SearchState& state, const Part& part, const Chain& chain, const Similarity& whole) {
    for (std::size_t k = 0; k < chain.frames.size(); ++k) {
        const Similarity predicted = whole * part.children[k].pose;
        const double size = scale_of(chain.frames[k]);
        const double far = abs(predicted.translation - whole.translation);
        if (abs(predicted.translation - chain.frames[k].translation) > guard_slack * state.tolerance.shift(size, far))
            return false;
        const double turn = state.tolerance.turn(state.part(part.children[k].part).radius);
        if (abs(predicted.linear - chain.frames[k].linear) > guard_slack * turn * size) return false;
    }
    return true;
}

struct Applied {
    std::vector<Chain> chains;
    Rule rule;
};

/// The chains of an evaluation by the production that they need: open ones together, rings by their number.
std::vector<Applied> productions_needed(const SearchState& state, const Hypothesis& hypothesis,
                                        const Evaluation& evaluation) {
    std::map<int, Applied> needed;
    for (const Chain& chain : evaluation.chains) {
        const bool ring = chain.closed && hypothesis.kind == RuleKind::sequence;
        Applied& applied = needed[ring ? static_cast<int>(chain.items.size()) : 0];
        applied.chains.push_back(chain);
        applied.rule.kind = ring ? RuleKind::ring : hypothesis.kind;
    }
    std::vector<Applied> list;
    for (auto& [unused, applied] : needed) {
        Rule& rule = applied.rule;
        rule.repeated = hypothesis.from;
        rule.step = evaluation.step;
        rule.turn_change = hypothesis.turn_change;
        rule.spin_change = hypothesis.spin_change;
        const double radius = child_radius(state, hypothesis);
        const bool keep_known = evaluation.known_rule >= 0 && rule.kind == RuleKind::sequence;
        if (!keep_known) {
            rule = fitted(rule, applied.chains, radius);
            rule = with_natural_values(rule, applied.chains, radius, natural_slack * state.tolerance.size);
        }
        if (rule.kind == RuleKind::group) rule.members = {{hypothesis.from, {}}, {hypothesis.to, rule.step}};
        list.push_back(std::move(applied));
    }
    return list;
}

void apply(SearchState& state, const Applied& applied, int known_rule, std::set<int>& touched, std::vector<int>& new_items) {
    int rule_index = applied.rule.kind == RuleKind::sequence ? known_rule : -1;
    const Rule rule = rule_index >= 0 ? state.rules.rules[static_cast<std::size_t>(rule_index)] : applied.rule;
    std::map<int, int> part_of_count;
    for (std::size_t p = 0; rule_index >= 0 && p < state.rules.parts.size(); ++p) {
        if (state.rules.parts[p].rule == rule_index) part_of_count[state.rules.parts[p].count] = static_cast<int>(p);
    }
    for (const Chain& chain : applied.chains) {
        const int count = static_cast<int>(chain.items.size());
        const auto known = part_of_count.find(rule.kind == RuleKind::group ? 1 : count);
        const Part part =
            known != part_of_count.end() ? state.part(known->second) : new_part(state, rule, rule_index, count);
        std::vector<Similarity> poses;
        std::vector<double> radii;
        for (const Child& child : part.children) {
            poses.push_back(child.pose);
            radii.push_back(std::max(1.0, state.part(child.part).radius));
        }
        const Similarity whole = group_pose(poses, chain.frames, radii);
        if (!members_fit(state, part, chain, whole)) continue;
        if (rule_index < 0) {
            rule_index = static_cast<int>(state.rules.rules.size());
            state.rules.rules.push_back(rule);
        }
        int part_index = known != part_of_count.end() ? known->second : -1;
        if (part_index < 0) {
            part_index = static_cast<int>(state.rules.parts.size());
            state.rules.parts.push_back(part);
            state.rules.parts.back().rule = rule_index;
            state.members.emplace_back();
            state.costs.emplace_back();
            part_of_count[part.count] = part_index;
        }
        for (std::size_t k = 0; k < chain.items.size(); ++k) regauge(state.rules, chain.items[k], chain.frames[k]);
        Item item;
        item.part = part_index;
        item.pose = whole;
        item.members = chain.items;
        item.first = state.item(chain.items.front()).first;
        for (const int member : chain.items) {
            Item& below = state.rules.items[static_cast<std::size_t>(member)];
            below.alive = false;
            item.first = std::min(item.first, below.first);
            touched.insert(below.part);
        }
        const int index = static_cast<int>(state.rules.items.size());
        state.rules.items.push_back(std::move(item));
        state.members[static_cast<std::size_t>(part_index)].push_back(index);
        touched.insert(part_index);
        new_items.push_back(index);
    }
}

}  // namespace

Part made_part(const SearchState& state, int rule, int count) {
    return new_part(state, state.rules.rules[static_cast<std::size_t>(rule)], rule, count);
}

Substitution substitute(SearchState& state, const Hypothesis& hypothesis, const Evaluation& evaluation) {
    Substitution substitution;
    std::set<int> touched;
    for (const Applied& applied : productions_needed(state, hypothesis, evaluation)) {
        apply(state, applied, evaluation.known_rule, touched, substitution.new_items);
    }
    substitution.touched_parts.assign(touched.begin(), touched.end());
    refresh(state, substitution.touched_parts);
    return substitution;
}

void improve_sequences(const SearchState& state, Substitution& made,
                       const std::function<void(int rule, std::set<int>& touched)>& improve) {
    std::set<int> rules;
    for (const int item : made.new_items) {
        const int rule = state.part(state.item(item).part).rule;
        if (state.rules.rules[static_cast<std::size_t>(rule)].kind == RuleKind::sequence) rules.insert(rule);
    }
    const auto before = static_cast<int>(state.rules.items.size());
    std::set<int> touched(made.touched_parts.begin(), made.touched_parts.end());
    for (const int rule : rules) improve(rule, touched);
    for (int i = before; i < static_cast<int>(state.rules.items.size()); ++i) made.new_items.push_back(i);
    std::erase_if(made.new_items, [&](int i) { return !state.item(i).alive; });
    made.touched_parts.assign(touched.begin(), touched.end());
}

}  // namespace rinceau
