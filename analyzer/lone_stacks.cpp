#include "analyzer/lone_stacks.h"

#include <algorithm>

#include "geometry/index.h"

namespace rinceau {

namespace {

/// How often each part stands below another item or is a part's child, and in how many roots.
std::vector<int> times_used(const RuleSet& rules, const std::vector<int>& roots) {
    std::vector<int> times(rules.parts.size(), 0);
    for (const int root : roots) ++times[at(rules.items[at(root)].part)];
    for (const Item& item : rules.items)
        for (const int member : item.members)
            if (member >= 0) times[at(rules.items[at(member)].part)] += 2;
    for (const Rule& rule : rules.rules) {
        if (rule.repeated >= 0) times[at(rule.repeated)] += 2;
        for (const Child& child : rule.members) times[at(child.part)] += 2;
        for (const Child& child : rule.leaves) times[at(child.part)] += 2;
    }
    return times;
}

bool is_in_place_of(const Similarity& a, const Similarity& b, double slack) {
    return a.mirrored == b.mirrored && abs(a.translation - b.translation) <= slack && abs(a.linear - b.linear) <= slack;
}

bool is_stack(const RuleSet& rules, const Item& item, double slack) {
    const Part& part = rules.parts[at(item.part)];
    if (part.rule < 0 || rules.rules[at(part.rule)].kind != RuleKind::group || item.members.size() < 2) return false;
    for (std::size_t k = 0; k < item.members.size(); ++k)
        if (!is_regular(rules, item, k)) return false;
    const Item& first = rules.items[at(item.members.front())];
    if (rules.parts[at(first.part)].look < 0) return false;
    return std::ranges::all_of(item.members, [&](int member) {
        const Item& other = rules.items[at(member)];
        return other.part == first.part && is_in_place_of(first.pose, other.pose, slack);
    });
}

}  // namespace

std::vector<bool> lone_stacks(const RuleSet& rules, const std::vector<int>& roots, double slack) {
    const std::vector<int> times = times_used(rules, roots);
    std::vector<bool> stacks(rules.parts.size(), false);
    for (const int root : roots) {
        const Item& item = rules.items[at(root)];
        if (times[at(item.part)] == 1 && is_stack(rules, item, slack)) stacks[at(item.part)] = true;
    }
    return stacks;
}

}  // namespace rinceau
