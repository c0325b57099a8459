#include "analyzer/rule_sets.h"

#include <algorithm>
#include <numeric>

#include "analyzer/group_frame.h"

namespace rinceau::test {

SymmetryGroup cyclic(int n) {
    SymmetryGroup group;
    for (int k = 1; k < n; ++k) group.elements.push_back(rotate(two_pi * k / n));
    return group;
}

SymmetryGroup dihedral(int n, double axis) {
    SymmetryGroup group = cyclic(n);
    for (int k = 0; k < n; ++k) group.elements.push_back({polar(1, 2 * axis + two_pi * k / n), {}, true});
    return group;
}

SymmetryGroup continuous() { return {.continuous = true}; }

Part look_part(int look, SymmetryGroup symmetry) {
    Part part;
    part.look = look;
    part.symmetry = std::move(symmetry);
    return part;
}

RuleSet copies(SymmetryGroup symmetry, const std::vector<Similarity>& poses) {
    RuleSet rules;
    rules.parts.push_back(look_part(0, std::move(symmetry)));
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const int element = static_cast<int>(i);
        rules.items.push_back({.part = 0, .pose = poses[i], .element = element, .first = element});
    }
    return rules;
}

RuleSet regauged_at_random(RuleSet rules, Random& random) {
    for (Item& item : rules.items) {
        const auto& gauges = rules.parts[static_cast<std::size_t>(item.part)].symmetry.elements;
        item.pose = item.pose * gauges[random.below(static_cast<std::uint32_t>(gauges.size()))];
    }
    return rules;
}

RuleSet grouped(RuleSet rules, Rule rule) {
    Part part;
    part.rule = static_cast<int>(rules.rules.size());
    Item whole{.part = static_cast<int>(rules.parts.size()), .first = 0};
    std::vector<Similarity> poses;
    for (std::size_t i = 0; i < rules.items.size(); ++i) {
        Item& item = rules.items[i];
        item.alive = false;
        whole.members.push_back(static_cast<int>(i));
        poses.push_back(item.pose);
    }
    const Similarity first = poses.front();
    for (Similarity& pose : poses) pose = inverse(first) * pose;
    const std::vector<Similarity> frames = centred(poses);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        part.children.push_back({rules.items[i].part, frames[i]});
        if (rule.kind == RuleKind::group) rule.members.push_back({rules.items[i].part, poses[i]});
    }
    part.count = rule.kind == RuleKind::group ? 1 : static_cast<int>(poses.size());
    whole.pose = first * inverse(frames.front());
    constexpr double equal = 1e-6;
    rules.parts.push_back(completed_part(rules, part, equal, equal));
    rules.rules.push_back(rule);
    rules.items.push_back(whole);
    return rules;
}

std::vector<int> counted(std::size_t count) {
    std::vector<int> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

double distance(const Similarity& a, const Similarity& b) {
    return abs(a.translation - b.translation) + abs(a.linear - b.linear) + (a.mirrored == b.mirrored ? 0 : 2);
}

double distance(const Similarity& a, const Similarity& b, const SymmetryGroup& symmetry) {
    if (symmetry.continuous) return abs(a.translation - b.translation) + std::abs(scale_of(a) - scale_of(b));
    double least = HUGE_VAL;
    for (const Similarity& s : symmetry.elements) least = std::min(least, distance(a, b * s));
    return least;
}

}  // namespace rinceau::test
