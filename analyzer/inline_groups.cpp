#include "analyzer/inline_groups.h"

#include <map>
#include <set>

namespace rinceau {

namespace {

bool is_group(const RuleSet& rules, int part) {
    const int rule = rules.parts[static_cast<std::size_t>(part)].rule;
    return rule >= 0 && rules.rules[static_cast<std::size_t>(rule)].kind == RuleKind::group;
}

/// Parts that stand in for others, or that something stands in for, or that are missing somewhere: exceptions name them.
std::set<int> parts_in_exceptions(const RuleSet& rules) {
    std::set<int> named;
    for (const Item& item : rules.items) {
        for (std::size_t k = 0; k < item.members.size(); ++k) {
            if (is_regular(rules, item, k)) continue;
            named.insert(rules.parts[static_cast<std::size_t>(item.part)].children[k].part);
            if (item.members[k] >= 0) named.insert(rules.items[static_cast<std::size_t>(item.members[k])].part);
        }
    }
    return named;
}

/// Parts that still have items, directly or below.
std::vector<char> parts_in_use(const RuleSet& rules) {
    std::vector<char> used(rules.parts.size(), 0);
    std::vector<int> open;
    for (const Item& item : rules.items) {
        if (item.alive && !used[static_cast<std::size_t>(item.part)]) {
            used[static_cast<std::size_t>(item.part)] = 1;
            open.push_back(item.part);
        }
    }
    for (const int part : parts_in_exceptions(rules)) {
        if (!used[static_cast<std::size_t>(part)]) open.push_back(part);
        used[static_cast<std::size_t>(part)] = 1;
    }
    while (!open.empty()) {
        const int part = open.back();
        open.pop_back();
        for (const Child& child : rules.parts[static_cast<std::size_t>(part)].children) {
            if (used[static_cast<std::size_t>(child.part)]) continue;
            used[static_cast<std::size_t>(child.part)] = 1;
            open.push_back(child.part);
        }
    }
    return used;
}

/// Groups that no root and only one place of one other group holds.
std::set<int> parts_to_splice(const RuleSet& rules) {
    std::map<int, int> places;
    std::set<int> kept = parts_in_exceptions(rules);
    const std::vector<char> used = parts_in_use(rules);
    for (const Item& item : rules.items) {
        if (item.alive) kept.insert(item.part);
    }
    for (std::size_t p = 0; p < rules.parts.size(); ++p) {
        if (!used[p]) continue;
        const bool group = is_group(rules, static_cast<int>(p));
        for (const Child& child : rules.parts[p].children) {
            ++places[child.part];
            if (!group) kept.insert(child.part);
        }
    }
    std::set<int> spliced;
    for (const auto& [part, count] : places) {
        if (count == 1 && !kept.contains(part) && is_group(rules, part)) spliced.insert(part);
    }
    return spliced;
}

}  // namespace

RuleSet with_inlined_groups(RuleSet rules) {
    const std::set<int> spliced = parts_to_splice(rules);
    // Parts are made after their children, so one pass in order resolves chains of any length.
    for (Part& part : rules.parts) {
        std::vector<Child> children;
        for (const Child& child : part.children) {
            if (!spliced.contains(child.part)) {
                children.push_back(child);
                continue;
            }
            for (const Child& inner : rules.parts[static_cast<std::size_t>(child.part)].children) {
                children.push_back({inner.part, child.pose * inner.pose});
            }
        }
        part.children = std::move(children);
    }
    for (Item& item : rules.items) {
        std::vector<int> members;
        for (const int member : item.members) {
            if (member < 0) {  // of a part that is kept
                members.push_back(member);
                continue;
            }
            const Item& below = rules.items[static_cast<std::size_t>(member)];
            if (spliced.contains(below.part)) {
                members.insert(members.end(), below.members.begin(), below.members.end());
            } else {
                members.push_back(member);
            }
        }
        item.members = std::move(members);
    }
    for (const Part& part : rules.parts) {
        if (part.rule < 0) continue;
        Rule& rule = rules.rules[static_cast<std::size_t>(part.rule)];
        if (rule.kind != RuleKind::group || part.children.empty()) continue;
        rule.members.clear();
        const Similarity to_first = inverse(part.children.front().pose);
        for (const Child& child : part.children) rule.members.push_back({child.part, to_first * child.pose});
    }
    return rules;
}

}  // namespace rinceau
