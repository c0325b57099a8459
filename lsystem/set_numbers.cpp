#include "lsystem/set_numbers.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <utility>

#include "lsystem/constant_values.h"
#include "lsystem/keep_rings.h"
#include "lsystem/number_slots.h"
#include "lsystem/number_text.h"
#include "lsystem/similar_name.h"

namespace rinceau {

namespace {

using How = NumberEdit::How;

std::string trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return std::string(text);
}

/// Names that hold what was asked for come first, then the one that is nearest.
[[noreturn]] void throw_unknown(const std::string& name, const std::vector<GrammarNumber>& numbers) {
    constexpr std::size_t most_named = 4;
    std::vector<std::string_view> known;
    std::vector<std::string> holding;
    for (const GrammarNumber& number : numbers) {
        if (number.rank == NumberRank::hidden && number.constant < 0) continue;
        known.push_back(number.name);
        if (number.name.find(name) != std::string::npos) holding.push_back(number.name);
    }
    std::string cure = did_you_mean(name, known);
    if (!holding.empty()) cure = ": there is";
    for (std::size_t i = 0; i < std::min(holding.size(), most_named); ++i) cure += (i > 0 ? ", " : " ") + holding[i];
    throw InputError({}, "expected the name of a number of the grammar, found '" + name + "'" + cure +
                             " ('rinceau set RULES' lists all)");
}

class NumberSetter {
  public:
    explicit NumberSetter(const Grammar& grammar) : edited(grammar) {}

    void apply(const NumberEdit& edit) {
        std::vector<GrammarNumber> numbers = grammar_numbers(edited);
        for (const GrammarNumber* target : targets_of(edit.name, numbers)) set(*target, edit);
        if (numbers_before.empty()) numbers_before = std::move(numbers);
    }
    Grammar edited;
    std::vector<std::string> changes;
    std::vector<std::string> set_names;
    std::vector<NumberSlot> set_slots;
    std::vector<GrammarNumber> numbers_before;  // of the first edit; empty without edits

  private:
    static std::vector<const GrammarNumber*> targets_of(const std::string& name, const std::vector<GrammarNumber>& numbers) {
        std::vector<const GrammarNumber*> found;
        const bool pattern = name.find('*') != std::string::npos;
        for (const GrammarNumber& number : numbers) {
            const bool other_way_to_say = number.rank == NumberRank::hidden && number.constant < 0;
            if (pattern ? other_way_to_say || !fits_name(name, number.name) : number.name != name) continue;
            const bool again = std::ranges::any_of(
                found, [&](const GrammarNumber* other) { return other->slots.front() == number.slots.front(); });
            if (number.parts.empty() && !again) found.push_back(&number);
            for (const std::string& part : number.parts)
                found.push_back(&*std::ranges::find(numbers, part, &GrammarNumber::name));
        }
        if (found.empty()) throw_unknown(name, numbers);
        return found;
    }

    void set(const GrammarNumber& number, const NumberEdit& edit) {
        const Scope constants = constants_of(edited);
        const auto given = value_of(edit.value, constants);
        const bool is_number = std::ranges::none_of(
            edit.value.postfix, [](const Expression::Node& node) { return node.op == Expression::Op::name; });
        const bool as_written =
            edit.how == How::set && (!given || !is_number) && number.slots.front().in == NumberSlot::In::expression;
        if (!as_written && !given)
            throw InputError({}, "expected a value of " + number.name + " that is a number, found " + to_text(edit.value));
        const double value = given ? combined(number.value, edit.how, *given) : number.value;
        if (given) expect_in_range(number, value);
        const Expression expression = as_written ? edit.value : number_expression(value);
        for (const NumberSlot& slot : number.slots) {
            if (slot.in == NumberSlot::In::expression) expect_no_cycle(slot.place, expression);
            edited = with_slot(std::move(edited), slot, expression);
        }
        say(number, as_written ? to_text(expression) : number_text(value));
    }

    static double combined(double old, How how, double given) {
        switch (how) {
            case How::add:
                return rounded(old + given);
            case How::subtract:
                return rounded(old - given);
            case How::multiply:
                return rounded(old * given);
            case How::divide:
                return rounded(old / given);
            default:
                return rounded(given);
        }
    }

    static void expect_in_range(const GrammarNumber& number, double value) {
        const bool scale_is_zero = number.kind == NumberKind::scale && value <= 0;
        const bool fits_kind = number.kind == NumberKind::angle || (value >= number.low && value <= number.high);
        if (std::isfinite(value) && fits_kind && !scale_is_zero && (!number.whole || value == std::round(value))) return;
        std::string range = number.whole ? "a whole number" : "a number";
        if (number.kind == NumberKind::scale)
            range += " above 0";
        else if (std::isfinite(number.low) && number.kind != NumberKind::angle)
            range += " from " + number_text(number.low) + " up";
        if (std::isfinite(number.high) && number.kind != NumberKind::angle) range += " to " + number_text(number.high);
        throw InputError(
            {}, "expected " + range + " for " + number.name + " (" + number.help + "), found " + number_text(value));
    }

    /// A constant uses constants above it only.
    void expect_no_cycle(const ExpressionPlace& place, const Expression& value) const {
        if (place.in != ExpressionPlace::In::constant) return;
        for (const Expression::Node& node : value.postfix) {
            if (node.op != Expression::Op::name) continue;
            for (std::size_t i = static_cast<std::size_t>(place.index); i < edited.constants.size(); ++i)
                if (edited.constants[i].name == node.name)
                    throw InputError({}, "expected constants above " +
                                             edited.constants[static_cast<std::size_t>(place.index)].name +
                                             " in its value, found " + node.name);
        }
    }

    void say(const GrammarNumber& number, const std::string& value) {
        std::string old = short_text(number.value);
        if (!number.written.empty() && number.constant < 0) old = number.written + " (" + old + ")";
        if (old == value) return;
        std::string change = number.name + ' ' + old + " -> " + value;
        if (number.constant >= 0) change += " (" + edited.constants[static_cast<std::size_t>(number.constant)].name + ")";
        if (std::ranges::find(changes, change) == changes.end()) changes.push_back(change);
        set_names.push_back(number.name);
        set_slots.insert(set_slots.end(), number.slots.begin(), number.slots.end());
    }
};

/// Numbers that have changed without being set: they are written by means of what was.
void add_followers(const NumberSetter& setter, std::vector<std::string>& changes) {
    constexpr std::size_t most_named = 6;
    std::unordered_map<std::string_view, double> old;
    for (const GrammarNumber& number : setter.numbers_before) old.emplace(number.name, number.value);
    std::vector<std::string> names;
    for (const GrammarNumber& number : grammar_numbers(setter.edited)) {
        if (!number.parts.empty() || (number.rank == NumberRank::hidden && number.constant < 0)) continue;
        if (std::ranges::find(setter.set_names, number.name) != setter.set_names.end()) continue;
        const auto same = old.find(number.name);
        if (same == old.end() || same->second == number.value) continue;
        const bool written_there =
            number.written.empty() && std::ranges::any_of(number.slots, [&](const NumberSlot& slot) {
                return std::ranges::any_of(setter.set_slots, [&](const NumberSlot& set) {
                    return set.in == slot.in && set.index == slot.index && same_expression(set.place, slot.place);
                });
            });
        if (written_there) continue;
        // "axiom.Row.count" says no more than "Row.count"
        const auto says_it = [&](const std::string& name) {
            return number.name.ends_with('.' + name.substr(0, name.find(' ')));
        };
        if (std::ranges::any_of(names, says_it) || std::ranges::any_of(setter.set_names, says_it)) continue;
        names.push_back(number.name + ' ' + short_text(same->second) + " -> " + short_text(number.value));
    }
    if (names.empty()) return;
    std::string text = "with it: ";
    for (std::size_t i = 0; i < std::min(names.size(), most_named); ++i) text += (i > 0 ? ", " : "") + names[i];
    if (names.size() > most_named) text += " and " + std::to_string(names.size() - most_named) + " more";
    changes.push_back(text);
}

}  // namespace

NumberEdit parse_number_edit(std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos || equals == 0)
        throw InputError({}, "expected NAME=VALUE, such as Row.count=12 or bay*=1.5, found '" + std::string(text) + "'");
    NumberEdit edit;
    std::string name = trimmed(text.substr(0, equals));
    std::string value = trimmed(text.substr(equals + 1));
    constexpr std::string_view operators = "+-*/";
    const std::size_t op = operators.find(name.back());
    // in "Row.*=3" the star belongs to the name
    const bool belongs_to_name = name.size() == 1 || (name.back() == '*' && name[name.size() - 2] == '.');
    if (op != std::string_view::npos && !belongs_to_name) {
        constexpr How hows[] = {How::add, How::subtract, How::multiply, How::divide};
        edit.how = hows[op];
        name.pop_back();
    }
    edit.name = trimmed(name);
    if (edit.how == How::set && value.ends_with('%')) {
        edit.how = How::multiply;
        value = "(" + value.substr(0, value.size() - 1) + ")/100";
    }
    try {
        edit.value = parse_expression(value);
    } catch (const InputError& error) {
        throw InputError({}, "the value of " + edit.name + ": " + error.what());
    }
    return edit;
}

EditResult set_numbers(const Grammar& grammar, std::span<const NumberEdit> edits, const SetOptions& options) {
    NumberSetter setter(grammar);
    for (const NumberEdit& edit : edits) setter.apply(edit);
    EditResult result{setter.edited, setter.changes};
    if (options.say_changes) add_followers(setter, result.changes);
    if (options.keep_rings_closed) {
        EditResult closed = keep_rings_closed(grammar, setter.edited, {.nearest_count = options.nearest_ring});
        result.grammar = std::move(closed.grammar);
        result.changes.insert(result.changes.end(), closed.changes.begin(), closed.changes.end());
    }
    if (!options.say_changes) result.changes.clear();
    return result;
}

}  // namespace rinceau
