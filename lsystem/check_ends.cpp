#include "lsystem/check_ends.h"

#include <algorithm>
#include <map>

namespace rinceau {

namespace {

std::string name_of(ProductionKind kind) {
    if (kind == ProductionKind::rewriting) return "production";
    return kind == ProductionKind::decomposition ? "decomposition" : "homomorphism";
}

/// A key is endless if one of its productions surely applies and every one that may apply makes an endless one: the largest
/// set of keys with this property, found by taking away what has a way out.
class EndChecker {
  public:
    EndChecker(const Grammar& grammar, const ProductionOrder& order, const std::set<std::string>& unsure)
        : grammar_(grammar), order_(order) {
        for (const auto& [key, indices] : order.alike) {
            if (order.applies_surely(key) && !unsure.contains(std::string(key.symbol))) endless_.insert(key);
        }
        count_endless_parts();
        while (!ending_.empty()) {
            const ProductionKey key = ending_.back();
            ending_.pop_back();
            take_away(key);
        }
    }

    std::vector<Warning> check() {
        for (const ProductionKey& start : endless_) follow(start);
        return std::move(warnings_);
    }

  private:
    const Grammar& grammar_;
    const ProductionOrder& order_;
    std::set<ProductionKey> endless_;
    std::vector<ProductionKey> ending_;                         // still to be taken away
    std::map<ProductionKey, std::vector<std::size_t>> makers_;  // productions by what they make, once for each time
    std::map<std::size_t, std::size_t> parts_;                  // endless modules in a production's successor
    std::set<ProductionKey> followed_;
    std::vector<Warning> warnings_;

    const Production& production(std::size_t index) const { return grammar_.productions[index]; }

    static ProductionKey key_of_module(ProductionKind kind, const ModuleTemplate& module) {
        return {kind, module.symbol, module.arguments.size()};
    }

    void count_endless_parts() {
        for (const ProductionKey& key : endless_) {
            for (const std::size_t index : order_.that_may_apply(grammar_, key)) {
                std::size_t& parts = parts_[index];
                for (const ModuleTemplate& module : production(index).successor) {
                    const auto part = endless_.find(key_of_module(key.kind, module));
                    if (part == endless_.end()) continue;
                    makers_[*part].push_back(index);
                    ++parts;
                }
                if (parts == 0) ending_.push_back(key);
            }
        }
    }

    void take_away(const ProductionKey& key) {
        if (endless_.erase(key) == 0) return;
        for (const std::size_t maker : makers_[key]) {
            if (--parts_[maker] == 0) ending_.push_back(key_of(production(maker)));
        }
    }

    /// What the first production of an endless key makes that is endless.
    ProductionKey next_of(const ProductionKey& key) const {
        const Production& first = production(order_.that_may_apply(grammar_, key).front());
        const auto part = std::ranges::find_if(first.successor, [&](const ModuleTemplate& module) {
            return endless_.contains(key_of_module(key.kind, module));
        });
        return key_of_module(key.kind, *part);
    }

    /// Names the circle that a key leads to, once.
    void follow(const ProductionKey& start) {
        std::vector<ProductionKey> way;
        ProductionKey key = start;
        for (; followed_.insert(key).second; key = next_of(key)) way.push_back(key);
        const auto circle = std::ranges::find(way, key);
        if (circle != way.end()) report({circle, way.end()});
    }

    void report(const std::vector<ProductionKey>& circle) {
        const Production& first = production(order_.that_may_apply(grammar_, circle.front()).front());
        std::string way;
        for (std::size_t i = 1; i < circle.size(); ++i) {
            way += i > 1 ? " and " : " by way of ";
            way += circle[i].symbol;
        }
        const std::string depth = first.kind == ProductionKind::rewriting ? ", or derive to a depth" : "";
        add_mistake(warnings_, first.place,
                    "expected a " + name_of(first.kind) + " that ends, found " + first.symbol + " in its own successor" +
                        way + " without a condition: add one, such as ': m > 0'" + depth);
    }
};

}  // namespace

std::vector<Warning> check_ends(const Grammar& grammar, const ProductionOrder& order, const std::set<std::string>& unsure) {
    return EndChecker(grammar, order, unsure).check();
}

}  // namespace rinceau
