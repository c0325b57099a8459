#pragma once
// Which of its productions is applied to a module. Internal to the folder.

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "lsystem/compile.h"

namespace rinceau {

class ProductionChoice {
  public:
    explicit ProductionChoice(const CompiledGrammar& grammar)
        : grammar_(grammar), stack_(static_cast<std::size_t>(grammar.stack_size)) {}

    /// Of productions, the first that fits and whose condition holds; if it has a weight, one of all those that have one,
    /// fit and hold. -1 = none.
    /// values_of(const CompiledProduction&) -> std::optional<const double*>: the values of the production's parameters,
    /// nothing if it does not fit; they stay until the next call.
    template <class ValuesOf>
    int choose(std::span<const int> productions, ValuesOf values_of, DrawKey key) {
        for (std::size_t i = 0; i < productions.size(); ++i) {
            const CompiledProduction& production = grammar_.productions[static_cast<std::size_t>(productions[i])];
            const std::optional<const double*> values = values_of(production);
            if (!values || !holds(production, productions[i], *values, key)) continue;
            return production.weighted ? drawn_by_weight(productions.subspan(i), values_of, key) : productions[i];
        }
        return -1;
    }

    /// The same for productions that fit by their number of parameters alone.
    int choose_by_count(std::span<const int> productions, std::span<const double> arguments, DrawKey key) {
        const int count = static_cast<int>(arguments.size());
        for (std::size_t i = 0; i < productions.size(); ++i) {
            const CompiledProduction& production = grammar_.productions[static_cast<std::size_t>(productions[i])];
            if (production.parameters != count || !holds(production, productions[i], arguments.data(), key)) continue;
            return production.weighted ? drawn_by_count(productions.subspan(i), arguments, key) : productions[i];
        }
        return -1;
    }

  private:
    const CompiledGrammar& grammar_;
    std::vector<double> stack_;

    int drawn_by_count(std::span<const int> productions, std::span<const double> arguments, DrawKey key) {
        const auto values_of = [arguments](const CompiledProduction& production) {
            const bool fits = production.parameters == static_cast<int>(arguments.size());
            return fits ? std::optional(arguments.data()) : std::nullopt;
        };
        return drawn_by_weight(productions, values_of, key);
    }

    bool holds(const CompiledProduction& production, int index, const double* values, DrawKey key) {
        if (!production.conditional) return true;
        const double result = evaluate(production.condition, values, stack_.data(), key);
        if (std::isnan(result)) throw_undefined(index);
        return result != 0;
    }

    /// Of productions, the first of which has a weight and fits: each that does so waits for an exponential time with its
    /// weight as the rate, and the first to come is applied. So each wins in proportion to its weight, and a change of one
    /// weight changes no choice between two others.
    template <class ValuesOf>
    int drawn_by_weight(std::span<const int> productions, ValuesOf values_of, DrawKey key) {
        int winner = -1;
        double earliest = std::numeric_limits<double>::infinity();
        for (const int index : productions) {
            const CompiledProduction& production = grammar_.productions[static_cast<std::size_t>(index)];
            if (!production.weighted) continue;
            const std::optional<const double*> values = values_of(production);
            if (!values || !holds(production, index, *values, key)) continue;
            const double weight = evaluate(production.weight, *values, stack_.data(), key);
            if (!(weight >= 0) || std::isinf(weight)) throw_bad_weight(index, weight);
            if (weight == 0) continue;
            const double time = exponential_draw(key_below(key, production.salt)) / weight;
            if (winner >= 0 && time >= earliest) continue;
            winner = index;
            earliest = time;
        }
        if (winner < 0) throw_no_weight(productions.front());
        return winner;
    }

    const Production& source_of(int production) const {
        return grammar_.grammar->productions[static_cast<std::size_t>(production)];
    }
    [[noreturn]] void throw_bad_weight(int production, double weight) const;
    [[noreturn]] void throw_no_weight(int production) const;
    [[noreturn]] void throw_undefined(int production) const;
};

}  // namespace rinceau
