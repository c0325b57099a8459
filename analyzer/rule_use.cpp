#include "analyzer/rule_use.h"

#include <algorithm>
#include <cmath>

namespace rinceau {

namespace {

constexpr double same_scale = 0.01;

void count_use(const RuleSet& rules, int item, RuleUse& use) {
    const Item& at = rules.items[static_cast<std::size_t>(item)];
    const int count = rules.parts[static_cast<std::size_t>(at.part)].count;
    if (use.item < 0) use = {item, count, count, true};
    use.fewest = std::min(use.fewest, count);
    use.most = std::max(use.most, count);
    const double first = scale_of(rules.items[static_cast<std::size_t>(use.item)].pose);
    if (std::abs(scale_of(at.pose) / first - 1) > same_scale) use.even = false;
}

}  // namespace

std::vector<RuleUse> rule_uses(const RuleSet& rules, const std::vector<int>& roots) {
    std::vector<RuleUse> uses(rules.rules.size());
    struct Place {
        int item = 0;
        int rule_above = -1;
    };
    std::vector<Place> open;
    for (auto root = roots.rbegin(); root != roots.rend(); ++root) open.push_back({*root, -1});
    while (!open.empty()) {
        const auto [item, rule_above] = open.back();
        open.pop_back();
        const Item& at = rules.items[static_cast<std::size_t>(item)];
        const int rule = rules.parts[static_cast<std::size_t>(at.part)].rule;
        // The trees within a tree are no uses of their own.
        if (rule >= 0 && rule != rule_above) count_use(rules, item, uses[static_cast<std::size_t>(rule)]);
        for (std::size_t k = at.members.size(); k-- > 0;) {
            if (at.members[k] >= 0) open.push_back({at.members[k], rule});
        }
    }
    return uses;
}

}  // namespace rinceau
