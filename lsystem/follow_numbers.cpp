#include "lsystem/follow_numbers.h"

#include <algorithm>
#include <optional>

#include "lsystem/numbers.h"

namespace rinceau {

namespace {

std::optional<ExpressionPlace> moved(ExpressionPlace place, const std::vector<int>& new_index) {
    const bool in_string = place.in == ExpressionPlace::In::module && place.string.in == StringPlace::In::production;
    const bool of_production = place.in == ExpressionPlace::In::condition || place.in == ExpressionPlace::In::weight;
    if (!in_string && !of_production) return place;
    int& index = in_string ? place.string.index : place.index;
    index = new_index.at(static_cast<std::size_t>(index));
    if (index < 0) return std::nullopt;
    return place;
}

/// False if one of its places is gone.
bool move_places(GrammarNumber& number, const std::vector<int>& new_index) {
    for (NumberSlot& slot : number.slots) {
        if (slot.in != NumberSlot::In::expression) continue;
        const auto place = moved(slot.place, new_index);
        if (!place) return false;
        slot.place = *place;
    }
    if (number.alias) number.alias = moved(*number.alias, new_index);
    return true;
}

bool same_number(const GrammarNumber& a, const GrammarNumber& b) {
    return a.kind == b.kind && a.rank == b.rank && a.parts.size() == b.parts.size() && a.alias == b.alias &&
           std::ranges::is_permutation(a.slots, b.slots);
}

}  // namespace

std::set<std::string> names_afterwards(const Grammar& before, const Grammar& after, const std::vector<int>& new_index,
                                       const std::set<std::string>& names) {
    std::set<std::string> result;
    if (names.empty()) return result;
    const std::vector<GrammarNumber> now = grammar_numbers(after);
    for (GrammarNumber& number : grammar_numbers(before)) {
        if (!names.contains(number.name) || !move_places(number, new_index)) continue;
        const auto same = std::ranges::find_if(now, [&](const GrammarNumber& other) { return same_number(number, other); });
        if (same != now.end()) result.insert(same->name);
    }
    return result;
}

}  // namespace rinceau
