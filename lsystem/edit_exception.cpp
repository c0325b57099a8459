#include "lsystem/edit_exception.h"

#include <algorithm>
#include <cmath>

#include "lsystem/number_slots.h"
#include "lsystem/turtle_commands.h"
#include "lsystem/turtle_step.h"

namespace rinceau {

namespace {

using Modules = std::vector<ModuleTemplate>;

constexpr double exact = 1e-9;  ///< of a length: what arithmetic leaves

double in_units(double value, double unit) { return unit > 0 ? rounded(std::round(value / unit) * unit) : rounded(value); }

/// The largest power of ten that is not above.
double unit_below(double value) { return value > 0 ? std::pow(10.0, std::floor(std::log10(value))) : 0; }

void add_command(Modules& string, const std::string& symbol, double argument, double neutral) {
    if (argument != neutral) string.push_back({symbol, {number_expression(argument)}, {}});
}

void add_turn(Modules& string, double angle) { add_command(string, angle < 0 ? "-" : "+", std::abs(angle), 0); }

/// The commands that bring the turtle along `map`; a tolerance of 0 keeps every digit.
Modules commands_of(const Similarity& map, double tolerance) {
    const double size = std::max(1.0, abs(map.translation));
    const TurtleStep step = to_turtle_step(map, std::max(tolerance, exact * size));
    const double angle_unit = unit_below(degrees(tolerance / std::max(step.advance, size)));
    const double turn = in_units(degrees(step.turn), angle_unit);
    Modules string;
    add_turn(string, turn);
    add_command(string, "f", in_units(step.advance, unit_below(tolerance)), 0);
    add_command(string, "*", in_units(step.scale, unit_below(tolerance / size)), 1);
    add_turn(string, in_units(degrees(step.turn) + degrees(step.spin) - turn, angle_unit));
    if (step.mirrored) string.push_back({"|", {}, {}});
    return string;
}

bool is_motion(const ModuleTemplate& module) {
    return module.symbol == "+" || module.symbol == "-" || module.symbol == "f" || module.symbol == "*" ||
           module.symbol == "|";
}

void append(Modules& string, const Modules& more) { string.insert(string.end(), more.begin(), more.end()); }

std::string address_text(const std::vector<int>& address) {
    std::string text;
    for (const int number : address) text += (text.empty() ? "" : ".") + std::to_string(number);
    return text;
}

/// The module in its seat: as the rules place it, and with what an exception has made of it since.
struct Seat {
    const PathModule* outer = nullptr;  ///< as the rules place it
    const PathModule* inner = nullptr;  ///< as it stands
};

Seat seat_of(const Grammar& grammar, const std::vector<PathModule>& path, std::size_t level) {
    const PathModule& module = path[level];
    if (level == 0) throw InputError({}, "expected a part of the drawing to change by itself, found the whole");
    if (module.address.empty())
        throw InputError({}, "expected a module with an address of its own, found a branch of " + module.symbol +
                                 ": select what it draws, or the tree as a whole");
    const bool contexts = std::ranges::any_of(grammar.productions, [](const Production& production) {
        return !production.left_context.empty() || !production.right_context.empty();
    });
    if (contexts) throw InputError({}, "expected rules without contexts for an exception, found a production with one");
    const PathModule& above = path[level - 1];
    const bool excepted = above.exception >= 0 && above.address == module.address;
    return {excepted ? &above : &module, &module};
}

/// The way that the module itself takes the turtle, for what follows it.
Modules own_way(const PathModule& module) { return commands_of(inverse(module.pose) * module.after, 0); }

Grammar with_exception(Grammar grammar, const PathModule& module, Modules successor) {
    const auto same = [&](const Exception& exception) { return exception.address == module.address; };
    const auto found = std::ranges::find_if(grammar.exceptions, same);
    if (found != grammar.exceptions.end()) {
        found->successor = std::move(successor);
    } else {
        grammar.exceptions.push_back({.address = module.address, .successor = std::move(successor)});
    }
    return grammar;
}

/// What an exception says of style, layer and colours, without what moves.
Modules said_otherwise(const Modules& successor) {
    Modules said;
    std::ranges::copy_if(successor, std::back_inserter(said), [](const ModuleTemplate& module) {
        return find_turtle_command(module.symbol) != nullptr && !is_motion(module) && module.symbol != "[" &&
               module.symbol != "]";
    });
    return said;
}

/// One module, with commands before it.
bool is_plain_stand_in(const Modules& successor, int position) {
    const auto symbols = std::ranges::count_if(
        successor, [](const ModuleTemplate& module) { return find_turtle_command(module.symbol) == nullptr; });
    return symbols == 1 && static_cast<std::size_t>(position) < successor.size();
}

}  // namespace

EditResult move_instance(const Grammar& grammar, const std::vector<PathModule>& path, std::size_t level,
                         const Similarity& by, double tolerance) {
    const Seat seat = seat_of(grammar, path, level);
    const std::string what = seat.inner->symbol + " at " + address_text(seat.outer->address);
    const Similarity to_seat = inverse(seat.outer->pose);
    const double own_tolerance = tolerance / scale_of(seat.outer->pose);
    Modules said;
    ModuleTemplate stands{seat.inner->symbol, {}, {}};
    if (seat.outer == seat.inner) {
        for (const double argument : seat.inner->arguments) stands.arguments.push_back(number_expression(rounded(argument)));
    } else {
        const Modules& old = grammar.exceptions[static_cast<std::size_t>(seat.outer->exception)].successor;
        if (!is_plain_stand_in(old, seat.inner->position))
            throw InputError({}, "expected one symbol in the exception at " + address_text(seat.outer->address) +
                                     ", found several: select one of them");
        said = said_otherwise(old);
        stands = old[static_cast<std::size_t>(seat.inner->position)];
    }
    const Modules motion = commands_of(to_seat * by * seat.inner->pose, own_tolerance);
    const bool as_ruled = motion.empty() && said.empty() && seat.outer->symbol == stands.symbol;
    Grammar changed = grammar;
    if (as_ruled) {
        std::erase_if(changed.exceptions,
                      [&](const Exception& exception) { return exception.address == seat.outer->address; });
        return {std::move(changed), {what + " stands as the rules say"}};
    }
    Modules successor{{"[", {}, {}}};
    append(successor, motion);
    append(successor, said);
    successor.push_back(stands);
    successor.push_back({"]", {}, {}});
    append(successor, own_way(*seat.outer));
    return {with_exception(std::move(changed), *seat.outer, std::move(successor)), {what + " moved by itself"}};
}

EditResult erase_instance(const Grammar& grammar, const std::vector<PathModule>& path, std::size_t level) {
    const Seat seat = seat_of(grammar, path, level);
    return {with_exception(grammar, *seat.outer, own_way(*seat.outer)),
            {seat.inner->symbol + " at " + address_text(seat.outer->address) + " erased"}};
}

}  // namespace rinceau
