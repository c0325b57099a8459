#include "lsystem/keep_locked.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "lsystem/constant_values.h"
#include "lsystem/expression_place.h"
#include "lsystem/grammar_text.h"
#include "lsystem/keep_rings.h"
#include "lsystem/noise_form.h"
#include "lsystem/number_slots.h"
#include "lsystem/set_numbers.h"

namespace rinceau {

namespace {

using NumbersByName = std::map<std::string, GrammarNumber>;

NumbersByName locked_numbers(const Grammar& grammar, const std::set<std::string>& locked) {
    NumbersByName result;
    for (GrammarNumber& number : grammar_numbers(grammar))
        if (locked.contains(number.name)) result.emplace(number.name, std::move(number));
    return result;
}

bool same_value(double a, double b) {
    constexpr double rounding = 1e-12;  // of the last digits that arithmetic leaves
    return std::abs(a - b) <= rounding * std::max(std::abs(a), std::abs(b));
}

std::vector<std::string> names_that_differ(const NumbersByName& before, const NumbersByName& after) {
    std::vector<std::string> names;
    for (const auto& [name, number] : before) {
        const auto now = after.find(name);
        if (now != after.end() && !same_value(number.value, now->second.value)) names.push_back(name);
    }
    return names;
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

std::string are_locked(const std::vector<std::string>& names) {
    return listed(names) + (names.size() == 1 ? " is locked" : " are locked");
}

/// What the number is written as, if that can be written again: no parameter and no factor is in it.
Expression value_to_put_back(const Grammar& before, const GrammarNumber& number) {
    const NumberSlot* slot = number.slots.size() == 1 ? &number.slots.front() : nullptr;
    if (slot != nullptr && slot->in == NumberSlot::In::expression && slot->slope == 1 && slot->offset == 0) {
        Expression written = part_at(before, slot->place);
        if (value_of(written, constants_of(before))) return written;
    }
    return number_expression(number.value);
}

/// The edit's noise is taken from the expressions that locked numbers are written in.
void remove_noise(const Grammar& before, Grammar& after, const NumbersByName& numbers, const NumbersByName& numbers_after,
                  std::set<std::string>& kept) {
    for (const auto& [name, number] : numbers) {
        const auto same = numbers_after.find(name);
        if (same == numbers_after.end() || same->second.slots.size() != number.slots.size()) continue;
        for (std::size_t i = 0; i < number.slots.size(); ++i) {
            if (number.slots[i].in != NumberSlot::In::expression) continue;
            if (same->second.slots[i].in != NumberSlot::In::expression) continue;
            const Expression& then = expression_at(before, number.slots[i].place);
            Expression& now = expression_at(after, same->second.slots[i].place);
            const Expression plain = without_noise(now);
            if (plain == now || now == then || plain != without_noise(then)) continue;
            now = then;
            kept.insert(name);
        }
    }
}

}  // namespace

EditResult keep_locked(const Grammar& before, EditResult edit, const std::set<std::string>& locked) {
    if (locked.empty()) return edit;
    const NumbersByName then = locked_numbers(before, locked);
    const std::string asked_for = to_text(edit.grammar);
    std::set<std::string> kept;
    remove_noise(before, edit.grammar, then, locked_numbers(edit.grammar, locked), kept);
    const std::vector<std::string> changed = names_that_differ(then, locked_numbers(edit.grammar, locked));
    for (const std::string& name : changed) {
        const NumberEdit back{.name = name, .value = value_to_put_back(before, then.at(name))};
        edit.grammar = set_numbers(edit.grammar, {&back, 1}, {.keep_rings_closed = false}).grammar;
        kept.insert(name);
    }
    if (kept.empty()) return edit;
    if (!changed.empty()) edit.grammar = keep_rings_closed(before, edit.grammar).grammar;
    const std::vector<std::string> left = names_that_differ(then, locked_numbers(edit.grammar, locked));
    if (!left.empty()) throw InputError({}, are_locked(left) + " and would change: unlock it, or do without this edit");
    const std::string text = to_text(edit.grammar);
    const std::vector<std::string> names(kept.begin(), kept.end());
    if (text != asked_for && text == to_text(before))
        throw InputError({}, are_locked(names) + ", and nothing else would change: unlock to change it");
    edit.changes.push_back(are_locked(names) + " and left as before");
    return edit;
}

}  // namespace rinceau
