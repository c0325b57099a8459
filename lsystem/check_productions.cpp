#include "lsystem/check_productions.h"

#include <algorithm>
#include <map>
#include <string>

#include "lsystem/number_text.h"
#include "lsystem/similar_name.h"

namespace rinceau {

namespace {

std::string line_of(const Production& production) { return "line " + std::to_string(production.place.line); }

class ProductionChecker {
  public:
    ProductionChecker(const Grammar& grammar, const KnownNames& names, const Scope& constants, const ProductionOrder& order)
        : grammar_(grammar), names_(names), unknown_(constants.parameters), scope_(constants), order_(order) {}

    std::vector<Warning> check(const std::set<std::string>& unsure) {
        for (std::size_t i = 0; i < grammar_.productions.size(); ++i) check_alone(grammar_.productions[i], order_.facts[i]);
        for (const auto& [key, indices] : order_.alike) {
            if (unsure.contains(std::string(key.symbol))) continue;
            check_order(key, indices);
            check_weights(indices);
        }
        return std::move(warnings_);
    }

  private:
    const Grammar& grammar_;
    const KnownNames& names_;
    std::vector<std::string> unknown_;  // constants whose value is not known
    Scope scope_;
    const ProductionOrder& order_;
    std::vector<Warning> warnings_;

    const Production& production(std::size_t index) const { return grammar_.productions[index]; }
    void warn(const SourcePlace& place, const std::string& message) { add_mistake(warnings_, place, message); }

    void check_alone(const Production& production, const ProductionFacts& facts) {
        scope_.parameters = names_in(production, unknown_);
        append(check_string(names_, production.successor, scope_));
        if (production.condition) append(check_here(*production.condition, production));
        if (production.weight) append(check_here(*production.weight, production));
        if (facts.never) {
            warn(production.place,
                 "expected a condition that can hold, found one that never does: change it, or take the "
                 "production away");
        }
        if (facts.weight && !(*facts.weight >= 0)) {
            warn(production.place, "expected a weight from 0, found " + number_text(*facts.weight) +
                                       ": write how often it is drawn beside the others, as in ': 0.5'");
        }
        for (const ContextModule& module : production.left_context) check_context(module);
        for (const ContextModule& module : production.right_context) check_context(module);
    }
    std::vector<Warning> check_here(const Expression& expression, const Production& production) const {
        return check_expression(names_, expression, scope_, production.place).mistakes;
    }
    void append(const std::vector<Warning>& found) {
        for (const Warning& warning : found) warn(warning.place, warning.message);
    }

    void check_context(const ContextModule& module) {
        if (names_.is_excused(module.symbol)) return;
        const auto found = names_.occurring.find(module.symbol);
        if (found == names_.occurring.end()) {
            warn(module.place, "expected a symbol that stands in the axiom or a successor, found '" + module.symbol +
                                   "', which stands in none" + did_you_mean(module.symbol, names_.symbols) +
                                   ": the production never applies");
        } else if (!found->second.contains(module.parameters.size())) {
            warn(module.place, "expected " + std::to_string(*found->second.begin()) + " parameter(s) of " + module.symbol +
                                   ", as it stands in the strings, found " + std::to_string(module.parameters.size()) +
                                   ": the production never applies");
        } else if (std::ranges::find(grammar_.ignored, module.symbol) != grammar_.ignored.end()) {
            warn(module.place, "expected a symbol that contexts see, found '" + module.symbol +
                                   "', which they look past: take it away from 'ignore'");
        } else if (order_.applies_surely({ProductionKind::decomposition, module.symbol, module.parameters.size()})) {
            warn(module.place, "expected a symbol that stays, found '" + module.symbol +
                                   "', which is decomposed at once: write what it is decomposed into");
        }
    }

    /// Productions of one key are tried in order; the first with a weight brings in all with weight.
    void check_order(const ProductionKey& key, const std::vector<std::size_t>& indices) {
        const std::vector<std::size_t> may_apply = order_.that_may_apply(grammar_, key);
        auto next = may_apply.begin();  // both are in the grammar's order
        const auto first = std::ranges::find_if(indices, [&](std::size_t index) { return order_.facts[index].always; });
        for (const std::size_t index : indices) {
            const bool applies = next != may_apply.end() && *next == index;
            if (applies) ++next;
            if (applies || order_.facts[index].never) continue;
            const Production& hiding = production(*first);
            const std::string found = "expected a production that can apply, found one that never does: the one in " +
                                      line_of(hiding) + " always comes first; ";
            const bool weighted = hiding.weight.has_value() || production(index).weight.has_value();
            warn(production(index).place, found + (!weighted       ? "give that one a condition"
                                                   : hiding.weight ? "give this one a weight, too, or write it before"
                                                                   : "give that one a weight, too, or write it behind"));
        }
        if (key.kind == ProductionKind::rewriting) check_decomposed(key, indices);
    }

    void check_decomposed(const ProductionKey& key, const std::vector<std::size_t>& indices) {
        const ProductionKey decomposed{ProductionKind::decomposition, key.symbol, key.arguments};
        if (!order_.applies_surely(decomposed)) return;
        warn(production(indices.front()).place,
             "expected a production that can apply, found one that never does: " + std::string(key.symbol) +
                 " is decomposed at once by the one in " + line_of(production(order_.alike.at(decomposed).front())) +
                 "; give that one a condition");
    }

    void check_weights(const std::vector<std::size_t>& indices) {
        const Production* first = nullptr;
        for (const std::size_t index : indices) {
            if (!production(index).weight) continue;
            if (order_.facts[index].weight != 0.0) return;
            if (first == nullptr) first = &production(index);
        }
        if (first == nullptr) return;
        warn(first->place,
             "expected a weight above 0 among those of " + first->symbol + ", found none: none of them is drawn");
    }
};

}  // namespace

std::vector<Warning> check_productions(const Grammar& grammar, const KnownNames& names, const Scope& constants,
                                       const ProductionOrder& order, const std::set<std::string>& unsure) {
    return ProductionChecker(grammar, names, constants, order).check(unsure);
}

}  // namespace rinceau
