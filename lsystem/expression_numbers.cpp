#include "lsystem/expression_numbers.h"

#include <optional>
#include <span>

#include "lsystem/constant_values.h"
#include "lsystem/noise_form.h"

namespace rinceau {

namespace {

using Op = Expression::Op;
using Part = NumberInExpression::Part;

int operands(const Expression::Node& node) {
    switch (node.op) {
        case Op::number:
        case Op::name:
            return 0;
        case Op::negate:
        case Op::logical_not:
            return 1;
        case Op::call:
            return node.arguments;
        default:
            return 2;
    }
}

/// Where the operand begins whose last node is last - 1.
int start_of(const Expression& expression, int last) {
    int missing = 1;
    while (missing > 0 && last > 0) {
        --last;
        missing += operands(expression.postfix[static_cast<std::size_t>(last)]) - 1;
    }
    return last;
}

class NumberFinder {
  public:
    NumberFinder(const Expression& expression, const Scope& constants) : expression_(expression), constants_(constants) {}

    std::vector<NumberInExpression> find() {
        int last = static_cast<int>(expression_.postfix.size());
        const auto noise = find_noise(expression_);
        if (noise) last = noise->base_size;
        if (!add_value(0, last, 1) && !add_product(0, last, 1) && !add_sum(last)) add_literals(last);
        if (noise) {
            const int at = noise->spread_at;
            result_.push_back({Part::noise, at, at + 1, noise->noise.spread, 1, {}, 1, noise->negative_at});
        }
        return std::move(result_);
    }

  private:
    const Expression& expression_;
    const Scope& constants_;
    std::vector<NumberInExpression> result_;

    const Expression::Node& node(int index) const { return expression_.postfix[static_cast<std::size_t>(index)]; }
    std::optional<double> value(int first, int last) const {
        return value_of({{expression_.postfix.begin() + first, expression_.postfix.begin() + last}}, constants_);
    }

    bool add_value(int first, int last, double slope) {
        const auto found = value(first, last);
        if (found) result_.push_back({Part::value, first, last, *found * slope, slope, {}, 1});
        return found.has_value();
    }

    bool is_parameter(int first, int last) const {
        return last - first == 1 && node(first).op == Op::name && !value(first, last);
    }

    /// b*m or m*b.
    bool add_product(int first, int last, double slope) {
        if (last - first < 3 || node(last - 1).op != Op::multiply) return false;
        const int middle = start_of(expression_, last - 1);
        const bool parameter_first = is_parameter(first, middle);
        if (!parameter_first && !is_parameter(middle, last - 1)) return false;
        const int from = parameter_first ? middle : first;
        const int to = parameter_first ? last - 1 : middle;
        const auto found = value(from, to);
        if (!found) return false;
        result_.push_back({Part::change, from, to, *found * slope, slope, node(parameter_first ? first : middle).name, 1});
        return true;
    }

    /// a + b*m, a - b*m, b*m + a, b*m - a.
    bool add_sum(int last) {
        const Op op = node(last - 1).op;
        if (op != Op::add && op != Op::subtract) return false;
        const int middle = start_of(expression_, last - 1);
        const double sign = op == Op::add ? 1 : -1;
        if (add_value(0, middle, 1)) {
            if (add_product(middle, last - 1, sign)) return true;
            result_.pop_back();
            return false;
        }
        if (!value(middle, last - 1) || !add_product(0, middle, 1)) return false;
        add_value(middle, last - 1, sign);
        return true;
    }

    void add_literals(int last) {
        int ordinal = 0;
        for (int i = 0; i < last; ++i)
            if (node(i).op == Op::number) result_.push_back({Part::literal, i, i + 1, node(i).number, 1, {}, ++ordinal});
    }
};

}  // namespace

std::vector<NumberInExpression> numbers_in(const Expression& expression, const Scope& constants) {
    if (expression.postfix.empty()) return {};
    return NumberFinder(expression, constants).find();
}

}  // namespace rinceau
