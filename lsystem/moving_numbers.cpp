#include "lsystem/moving_numbers.h"

#include <algorithm>

#include "lsystem/approach.h"
#include "lsystem/ring.h"

namespace rinceau {

namespace {

bool is_motion(NumberKind kind) {
    return kind == NumberKind::angle || kind == NumberKind::length || kind == NumberKind::scale || kind == NumberKind::other;
}

class NumberFinder {
  public:
    NumberFinder(const Grammar& grammar, const std::vector<GrammarNumber>& numbers) : grammar_(grammar), numbers_(numbers) {}

    bool has(const StringPlace& string) const {
        const auto size = string.in == StringPlace::In::production  ? grammar_.productions.size()
                          : string.in == StringPlace::In::exception ? grammar_.exceptions.size()
                                                                    : 1;
        return static_cast<std::size_t>(string.index) < size;
    }

    /// Those at some of the positions of the string, in order of the list.
    std::vector<GrammarNumber> at(const StringPlace& string, const std::vector<int>& positions) const {
        std::vector<GrammarNumber> found;
        for (const GrammarNumber& number : numbers_) {
            if (!is_motion(number.kind) || !number.parts.empty() || number.whole) continue;
            if (number.rank == NumberRank::hidden && number.constant < 0) continue;
            if (!stands(number, string, positions)) continue;
            const GrammarNumber& known = by_its_own_name(number);
            if (std::ranges::find(found, known.name, &GrammarNumber::name) == found.end()) found.push_back(known);
        }
        return found;
    }

    static bool stands(const GrammarNumber& number, const StringPlace& string, const std::vector<int>& positions) {
        const auto here = [&](const ExpressionPlace& place) {
            return place.in == ExpressionPlace::In::module && place.string == string &&
                   std::ranges::find(positions, place.position) != positions.end();
        };
        return (number.alias && here(*number.alias)) || std::ranges::any_of(number.slots, [&](const NumberSlot& slot) {
                   return slot.in == NumberSlot::In::expression && here(slot.place);
               });
    }

  private:
    const Grammar& grammar_;
    const std::vector<GrammarNumber>& numbers_;

    /// The constant itself, for a number that is written as one.
    const GrammarNumber& by_its_own_name(const GrammarNumber& number) const {
        if (number.constant < 0) return number;
        const std::string& constant = grammar_.constants[static_cast<std::size_t>(number.constant)].name;
        const auto found = std::ranges::find(numbers_, constant, &GrammarNumber::name);
        return found == numbers_.end() ? number : *found;
    }
};

/// Where the production's own symbol stands in its successor; -1 = nowhere.
int own_position(const Production& production) {
    const auto own = std::ranges::find(production.successor, production.symbol, &ModuleTemplate::symbol);
    return own == production.successor.end() ? -1 : static_cast<int>(own - production.successor.begin());
}

bool is_closed_ring(const std::vector<Ring>& rings, const PathModule& sequence) {
    return std::ranges::any_of(rings, [&](const Ring& ring) {
        return ring.loop.production == sequence.production && ring.use.string == sequence.string &&
               ring.use.position == sequence.position;
    });
}

}  // namespace

std::vector<NumberGroup> moving_numbers(const Grammar& grammar, const std::vector<GrammarNumber>& numbers,
                                        const std::vector<PathModule>& path, std::size_t level) {
    const NumberFinder finder(grammar, numbers);
    const std::vector<Ring> rings = closed_rings(grammar);
    std::vector<NumberGroup> groups;
    const auto add = [&](std::size_t at, bool step, std::vector<GrammarNumber> found) {
        if (!found.empty()) groups.push_back({at, step, std::move(found)});
    };
    for (std::size_t at = level; at > 0; --at) {
        const PathModule& module = path[at];
        const PathModule& above = path[at - 1];
        if (!finder.has(module.string)) continue;  // it comes from another file
        if (module.part > 0 && module.string.in == StringPlace::In::production) {
            const Production& rule = grammar.productions[static_cast<std::size_t>(above.production)];
            std::vector<GrammarNumber> found = finder.at(module.string, way_to(rule.successor, own_position(rule)));
            if (is_closed_ring(rings, above))
                std::erase_if(found, [](const GrammarNumber& number) { return number.kind == NumberKind::angle; });
            add(at, true, std::move(found));
        }
        add(at, false, finder.at(module.string, way_to(string_at(grammar, module.string), module.position)));
    }
    return groups;
}

std::vector<GrammarNumber> angles_before(const Grammar& grammar, const std::vector<GrammarNumber>& numbers,
                                         const PathModule& module) {
    std::vector<GrammarNumber> found;
    if (!NumberFinder(grammar, numbers).has(module.string)) return found;
    const std::vector<int> way = way_to(string_at(grammar, module.string), module.position);
    std::ranges::copy_if(numbers, std::back_inserter(found), [&](const GrammarNumber& number) {
        return number.kind == NumberKind::angle && number.parts.empty() && NumberFinder::stands(number, module.string, way);
    });
    return found;
}

}  // namespace rinceau
