#include "lsystem/moved_exceptions.h"

#include <algorithm>
#include <map>
#include <optional>

#include "lsystem/expression_place.h"
#include "lsystem/interpret.h"

namespace rinceau {
namespace {

using Address = std::vector<int>;

/// A terminal on its way: at each level of the address, is the module one of the symbol?
struct Way {
    Address address;
    std::vector<bool> is_symbol;
};

std::vector<Way> ways_to_terminals(Grammar grammar, const std::string& symbol) {
    grammar.exceptions.clear();
    std::vector<Way> ways;
    visit_placements(grammar, {.addresses = true, .trails = true}, [&](const Placement& placement) {
        Way way{placement.address, {}};
        for (const Occurrence& occurrence : placement.trail) {
            const StringPlace place = occurrence.production < 0
                                          ? StringPlace{StringPlace::In::axiom, 0}
                                          : StringPlace{StringPlace::In::production, occurrence.production};
            way.is_symbol.push_back(string_at(grammar, place)[static_cast<std::size_t>(occurrence.position)].symbol ==
                                    symbol);
        }
        ways.push_back(std::move(way));
    });
    return ways;
}

std::string address_text(const Address& address) {
    std::string text;
    for (const int number : address) text += (text.empty() ? "" : ".") + std::to_string(number);
    return text;
}

[[noreturn]] void refuse(const Exception& exception, const std::string& why) {
    throw InputError(exception.place, "expected exceptions that can be kept, found " + address_text(exception.address) +
                                          ", " + why + ": take it away first");
}

bool begins_with(const Address& address, const Address& front) {
    return front.size() <= address.size() && std::equal(front.begin(), front.end(), address.begin());
}

/// The front of `after` with as many levels as `levels` of `before` has, modules of the symbol not counted.
std::optional<Address> same_front(const Way& before, const Way& after, std::size_t levels) {
    if (before.is_symbol.size() < levels) return {};
    const auto end = before.is_symbol.begin() + static_cast<std::ptrdiff_t>(levels);
    auto left = std::count(before.is_symbol.begin(), end, false);
    Address front;
    for (std::size_t i = 0; i < after.address.size() && i < after.is_symbol.size() && left > 0; ++i) {
        front.push_back(after.address[i]);
        if (!after.is_symbol[i]) --left;
    }
    if (left > 0) return {};
    return front;
}

}  // namespace

std::vector<Exception> moved_exceptions(const Grammar& before, const Grammar& after, const std::string& symbol) {
    std::vector<Exception> moved = before.exceptions;
    if (moved.empty()) return moved;
    const std::vector<Way> then = ways_to_terminals(before, symbol);
    const std::vector<Way> now = ways_to_terminals(after, symbol);
    std::map<Address, std::size_t> first;  // terminal below the front of an address
    for (std::size_t i = 0; i < then.size(); ++i)
        for (std::size_t length = 1; length <= then[i].address.size(); ++length)
            first.try_emplace({then[i].address.begin(), then[i].address.begin() + static_cast<std::ptrdiff_t>(length)}, i);
    std::map<Address, const Exception*> known;
    for (const Exception& exception : before.exceptions) known[exception.address] = &exception;
    for (Exception& exception : moved) {
        const auto next = known.upper_bound(exception.address);
        if (next != known.end() && begins_with(next->first, exception.address))
            refuse(*next->second, "which is below another");
        const auto terminal = first.find(exception.address);
        if (terminal == first.end() || terminal->second >= now.size()) refuse(exception, "where nothing is drawn");
        const Way& way = then[terminal->second];
        const std::size_t levels = exception.address.size();
        if (way.is_symbol.size() < levels || way.is_symbol[levels - 1]) refuse(exception, "which is a module of " + symbol);
        const auto front = same_front(way, now[terminal->second], levels);
        if (!front) refuse(exception, "which has no place then");
        exception.address = *front;
    }
    return moved;
}

}  // namespace rinceau
