#include "growth/surface/shape_expressions.h"

#include <algorithm>
#include <cmath>

namespace rinceau {

double rule_draw(DrawKey key) {
    constexpr std::uint64_t salt_of_choice = ~std::uint64_t{0};  // no command has that ordinal
    return uniform_draw(key_below(key, salt_of_choice));
}

ShapeEvaluator::ShapeEvaluator(const CompiledShapeGrammar& grammar)
    : slots_(static_cast<std::size_t>(grammar.slots)), stack_(static_cast<std::size_t>(grammar.stack_size)) {}

double ShapeEvaluator::evaluated(const ShapeProgram& program, std::span<const double> parameters, DrawKey key,
                                 QuerySource& queries) {
    if (program.queries.empty()) return evaluate(program.program, parameters.data(), stack_.data(), key);
    const auto count = static_cast<std::size_t>(program.parameters);
    std::copy_n(parameters.begin(), count, slots_.begin());
    for (std::size_t i = 0; i < program.queries.size(); ++i) slots_[count + i] = queries.answer(program.queries[i]);
    return evaluate(program.program, slots_.data(), stack_.data(), key);
}

double ShapeEvaluator::finite(const ShapeProgram& program, std::span<const double> parameters, DrawKey key,
                              QuerySource& queries) {
    const double value = evaluated(program, parameters, key, queries);
    if (std::isfinite(value)) return value;
    throw InputError(*program.place, "expected a finite number, found that '" + to_text(program.expression) +
                                         (std::isnan(value) ? "' has no value here" : "' is infinite here"));
}

bool ShapeEvaluator::holds(const CompiledShapeRule& rule, std::span<const double> parameters, DrawKey key,
                           QuerySource& queries) {
    return std::ranges::all_of(rule.condition, [&](const ShapeProgram& part) {
        const double value = part.constant ? part.value : evaluated(part, parameters, key, queries);
        if (std::isnan(value)) {
            throw InputError(*part.place, "expected a condition that is true or false, found that '" +
                                              to_text(part.expression) + "' has no value here");
        }
        return value != 0;
    });
}

}  // namespace rinceau
