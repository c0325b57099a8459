#include "analyzer/rule_model.h"

#include <algorithm>
#include <cmath>

#include "lsystem/turtle_step.h"

namespace rinceau {

static constexpr double smallest_size = 1e-6;  // of a repetition, where a row shrinks to nothing

Similarity linear_step(const Rule& rule, int k) {
    if (rule.kind != RuleKind::linear) return rule.step;
    TurtleStep step = to_turtle_step(rule.step);
    step.turn += k * rule.turn_change;
    step.advance = (step.advance + k * rule.advance_change) * std::pow(rule.advance_factor, k);
    step.spin += k * rule.spin_change;
    return to_similarity(step);
}

std::vector<Similarity> repetition_poses(const Rule& rule, int count) {
    std::vector<Similarity> poses(static_cast<std::size_t>(count));
    if (rule.kind == RuleKind::spiral) {
        const Similarity to_first = inverse(spiral_pose(rule.spiral, spiral_index(rule.spiral, 0)));
        for (int k = 1; k < count; ++k) {
            poses[static_cast<std::size_t>(k)] = to_first * spiral_pose(rule.spiral, spiral_index(rule.spiral, k));
        }
        return poses;
    }
    const bool linear = rule.kind == RuleKind::linear;
    Similarity place = linear ? translate(rule.seat) : Similarity{};
    for (int k = 1; k < count; ++k) {
        place = place * linear_step(rule, k - 1);
        poses[static_cast<std::size_t>(k)] =
            linear ? place * scale_by(std::max(smallest_size, 1 + k * rule.size_change)) * translate(-rule.seat) : place;
    }
    return poses;
}

bool is_regular(const RuleSet& rules, const Item& item, std::size_t k) {
    const int member = item.members[k];
    if (member < 0) return false;
    const Part& part = rules.parts[static_cast<std::size_t>(item.part)];
    return rules.items[static_cast<std::size_t>(member)].part == part.children[k].part;
}

std::vector<int> root_items(const RuleSet& rules) {
    std::vector<int> roots;
    for (std::size_t i = 0; i < rules.items.size(); ++i) {
        if (rules.items[i].alive) roots.push_back(static_cast<int>(i));
    }
    std::ranges::sort(roots, {}, [&](int i) { return std::pair{rules.items[static_cast<std::size_t>(i)].first, i}; });
    return roots;
}

static void collect_elements(const RuleSet& rules, int item, std::vector<int>& elements) {
    const Item& at = rules.items[static_cast<std::size_t>(item)];
    if (at.element >= 0) elements.push_back(at.element);
    for (const int member : at.members) {
        if (member >= 0) collect_elements(rules, member, elements);
    }
}

std::vector<int> elements_below(const RuleSet& rules, int item) {
    std::vector<int> elements;
    collect_elements(rules, item, elements);
    return elements;
}

}  // namespace rinceau
