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

/// Which rules use which, in the order of their members; nodes are rules.
class RuleOrder {
  public:
    explicit RuleOrder(const RuleSet& rules) : rules_(rules), below_(rules.rules.size()), entered_(rules.rules.size(), false) {
        for (const Part& part : rules.parts) {
            for (const Child& child : part.children) add_use(part, child.part);
        }
        for (const Item& item : rules.items) {
            const Part& part = rules.parts[static_cast<std::size_t>(item.part)];
            for (std::size_t k = 0; k < item.members.size(); ++k) {
                if (item.members[k] < 0) continue;
                const int member = rules.items[static_cast<std::size_t>(item.members[k])].part;
                if (k >= part.children.size() || member != part.children[k].part) add_use(part, member);  // stands in
            }
        }
    }
    /// From the last root to the first, each rule after all that it uses: read backwards, the order of a text.
    std::vector<int> from_the_bottom(const std::vector<int>& roots) {
        for (auto root = roots.rbegin(); root != roots.rend(); ++root) {
            enter(rule_of(rules_.items[static_cast<std::size_t>(*root)].part));
        }
        return std::move(order_);
    }

  private:
    int rule_of(int part) const { return rules_.parts[static_cast<std::size_t>(part)].rule; }
    void add_use(const Part& part, int used) {
        if (part.rule < 0 || rule_of(used) < 0) return;
        std::vector<int>& below = below_[static_cast<std::size_t>(part.rule)];
        if (std::ranges::find(below, rule_of(used)) == below.end()) below.push_back(rule_of(used));
    }
    void enter(int rule) {
        if (rule < 0 || entered_[static_cast<std::size_t>(rule)]) return;
        entered_[static_cast<std::size_t>(rule)] = true;
        const std::vector<int>& below = below_[static_cast<std::size_t>(rule)];
        for (std::size_t k = below.size(); k-- > 0;) enter(below[k]);
        order_.push_back(rule);
    }

    const RuleSet& rules_;
    std::vector<std::vector<int>> below_;
    std::vector<bool> entered_;
    std::vector<int> order_;
};

}  // namespace

std::vector<int> parts_top_down(const RuleSet& rules, const std::vector<int>& roots) {
    std::vector<std::vector<int>> parts_of_rule(rules.rules.size());
    std::vector<bool> in_use(rules.parts.size(), false);
    std::vector<int> open = roots;
    while (!open.empty()) {
        const Item& item = rules.items[static_cast<std::size_t>(open.back())];
        open.pop_back();
        in_use[static_cast<std::size_t>(item.part)] = true;
        for (const int member : item.members) {
            if (member >= 0) open.push_back(member);
        }
    }
    for (std::size_t p = rules.parts.size(); p-- > 0;) {
        if (rules.parts[p].rule >= 0 && in_use[p]) {
            parts_of_rule[static_cast<std::size_t>(rules.parts[p].rule)].push_back(static_cast<int>(p));
        }
    }
    std::vector<int> parts;
    const std::vector<int> order = RuleOrder(rules).from_the_bottom(roots);
    for (auto rule = order.rbegin(); rule != order.rend(); ++rule) {
        const std::vector<int>& of_rule = parts_of_rule[static_cast<std::size_t>(*rule)];
        parts.insert(parts.end(), of_rule.begin(), of_rule.end());
    }
    return parts;
}

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
