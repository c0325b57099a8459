#include "lsystem/number_slots.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "lsystem/approach.h"
#include "lsystem/constant_values.h"
#include "lsystem/noise_form.h"
#include "lsystem/number_text.h"

namespace rinceau {

namespace {

using Op = Expression::Op;

/// slope * value + offset; a number where it can be.
Expression scaled(const Expression& value, double slope, double offset) {
    if (is_plain_number(value)) return number_expression(rounded(slope * value.postfix.front().number + offset));
    Expression result = value;
    const auto append = [&](double number, Op op) {
        result.postfix.push_back({Op::number, number, {}, 0});
        result.postfix.push_back({op, 0, {}, 0});
    };
    if (slope == -1) {
        result.postfix.push_back({Op::negate, 0, {}, 0});
    } else if (slope != 1) {
        append(slope, Op::multiply);
    }
    if (offset != 0) append(std::abs(offset), offset > 0 ? Op::add : Op::subtract);
    return result;
}

/// 60 + -10*m is 60 - 10*m.
void set_sign_apart(Grammar& grammar, const ExpressionPlace& place) {
    auto& nodes = expression_at(grammar, place).postfix;
    const auto first = static_cast<std::size_t>(place.first);
    if (nodes[first].op != Op::number || nodes[first].number >= 0) return;
    const auto is = [&](std::size_t i, Op op) { return i < nodes.size() && nodes[i].op == op; };
    std::size_t sum = first + 1;
    if (is(sum, Op::name) && is(sum + 1, Op::multiply)) {
        sum += 2;
    } else if (is(sum, Op::multiply)) {
        sum += 1;
    }
    if (!is(sum, Op::add) && !is(sum, Op::subtract)) return;
    nodes[first].number = -nodes[first].number;
    nodes[sum].op = nodes[sum].op == Op::add ? Op::subtract : Op::add;
}

/// -(-30) is +(30). Where numbers are random, commands stay what they are: draws are told apart by them.
void set_right_way_round(Grammar& grammar, const ExpressionPlace& place) {
    if (place.in != ExpressionPlace::In::module) return;
    auto& string = string_at(grammar, place.string);
    ModuleTemplate& module = string[static_cast<std::size_t>(place.position)];
    if (turn_sign(module) == 0 || !is_plain_number(module.arguments.front())) return;
    double& angle = module.arguments.front().postfix.front().number;
    const bool random = std::ranges::any_of(
        string, [](const ModuleTemplate& other) { return std::ranges::any_of(other.arguments, is_random); });
    if (angle >= 0 || random) return;
    angle = -angle;
    module.symbol = module.symbol == "+" ? "-" : "+";
}

double with_digits(double value, int digits) {
    std::array<char, 40> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
    double result = value;
    std::from_chars(text.data(), end.ptr, result);
    return result == 0 ? 0 : result;
}

void set_canvas(Box& box, int index, double value) {
    switch (index) {
        case 0:
            box.high.x += value - box.low.x;
            box.low.x = value;
            break;
        case 1:
            box.low.y += -value - box.high.y;
            box.high.y = -value;
            break;
        case 2:
            box.high.x = box.low.x + value;
            break;
        default:
            box.low.y = box.high.y - value;
    }
}

}  // namespace

double rounded(double value) {
    constexpr int digits = 15;  // what a double always holds
    return with_digits(value, digits);
}

std::string short_text(double value) {
    constexpr int digits = 6;
    return number_text(with_digits(value, digits));
}

Grammar with_slot(Grammar grammar, const NumberSlot& slot, const Expression& value) {
    if (slot.in == NumberSlot::In::expression) {
        grammar = with_part(std::move(grammar), slot.place, scaled(value, slot.slope, slot.offset));
        set_sign_apart(grammar, slot.place);
        set_right_way_round(grammar, slot.place);
        return grammar;
    }
    const double number = value.postfix.front().number;
    if (slot.in == NumberSlot::In::canvas) {
        set_canvas(grammar.canvas, slot.index, number);
    } else if (slot.in == NumberSlot::In::seed) {
        grammar.seed = static_cast<std::uint64_t>(number);
    } else {
        Style& style = grammar.styles[static_cast<std::size_t>(slot.index)].style;
        if (slot.in == NumberSlot::In::stroke_width) style.stroke.width = number;
        if (slot.in == NumberSlot::In::fill_opacity) style.fill_opacity = number;
        if (slot.in == NumberSlot::In::stroke_opacity) style.stroke.opacity = number;
        if (slot.in == NumberSlot::In::opacity) style.opacity = number;
    }
    return grammar;
}

std::string name_of_place(const std::vector<GrammarNumber>& numbers, const ExpressionPlace& place) {
    const GrammarNumber* best = nullptr;
    for (const GrammarNumber& number : numbers) {
        const bool here = std::ranges::any_of(number.slots, [&](const NumberSlot& slot) {
            return slot.in == NumberSlot::In::expression && same_expression(slot.place, place);
        });
        if (here && (best == nullptr || number.rank < best->rank)) best = &number;
    }
    return best == nullptr ? "" : best->name;
}

}  // namespace rinceau
