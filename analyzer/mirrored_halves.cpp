#include "analyzer/mirrored_halves.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace rinceau {

namespace {

constexpr double allowed = 0.005;  // element sizes, the unit of a part's frame

/// The reflection that `step` is, or nothing if it glides or grows.
std::optional<Similarity> as_reflection(const Similarity& step, double radius) {
    if (!step.mirrored || std::abs(abs(step.linear) - 1) * std::max(1.0, radius) > allowed) return std::nullopt;
    const Complex linear = step.linear / abs(step.linear);
    // What a reflection does not have: a shift along its axis.
    const Point glide = 0.5 * (linear * conj(step.translation) + step.translation);
    if (abs(glide) > allowed) return std::nullopt;
    return Similarity{linear, step.translation - glide, true};
}

/// A turtle on the reflection's axis, at the foot of the origin, that heads along the axis.
Similarity turtle_on_axis(const Similarity& reflection) {
    return {polar(1, 0.5 * arg(reflection.linear)) * Complex{0, -1}, 0.5 * reflection.translation, false};
}

bool is_group(const RuleSet& rules, int part) {
    const int rule = rules.parts[static_cast<std::size_t>(part)].rule;
    return rule >= 0 && rules.rules[static_cast<std::size_t>(rule)].kind == RuleKind::group;
}

/// The only part of each rule, -1 if there are several or none.
std::vector<int> only_parts(const RuleSet& rules) {
    std::vector<int> only(rules.rules.size(), -1);
    std::vector<int> count(rules.rules.size(), 0);
    for (std::size_t p = 0; p < rules.parts.size(); ++p) {
        if (rules.parts[p].rule < 0) continue;
        const auto rule = static_cast<std::size_t>(rules.parts[p].rule);
        only[rule] = ++count[rule] == 1 ? static_cast<int>(p) : -1;
    }
    return only;
}

}  // namespace

RuleSet with_mirrored_halves(RuleSet rules) {
    const std::vector<int> only = only_parts(rules);
    for (std::size_t r = 0; r < rules.rules.size(); ++r) {
        Rule& rule = rules.rules[r];
        if (rule.kind != RuleKind::sequence || only[r] < 0 || !is_group(rules, rule.repeated)) continue;
        Part& pair = rules.parts[static_cast<std::size_t>(only[r])];
        Part& half = rules.parts[static_cast<std::size_t>(rule.repeated)];
        if (pair.count != 2 || pair.children.size() != 2 || half.pivot) continue;
        const auto reflection = as_reflection(rule.step, half.radius);
        if (!reflection) continue;
        half.pivot = turtle_on_axis(*reflection);
        const Similarity first = pair.children.front().pose;
        pair.children.back().pose = first * *reflection;
        pair.pivot = first * *half.pivot;
        pair.pivot->linear = pair.pivot->linear / abs(pair.pivot->linear);
        pair.count = 1;
        rule.kind = RuleKind::group;
        rule.members = {{rule.repeated, {}}, {rule.repeated, *reflection}};
    }
    return rules;
}

}  // namespace rinceau
