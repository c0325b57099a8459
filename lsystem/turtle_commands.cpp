#include "lsystem/turtle_commands.h"

#include <algorithm>
#include <array>

namespace rinceau {

namespace {

constexpr std::array commands{
    TurtleCommandInfo{TurtleCommand::left, "+", 1, "turn left by the angle, in degrees"},
    TurtleCommandInfo{TurtleCommand::right, "-", 1, "turn right by the angle, in degrees"},
    TurtleCommandInfo{TurtleCommand::forward, "f", 1, "move along the heading, by the length times the scale"},
    TurtleCommandInfo{TurtleCommand::scale, "*", 1, "multiply the scale by a number above 0"},
    TurtleCommandInfo{TurtleCommand::mirror, "|", 0, "mirror what follows about the heading"},
    TurtleCommandInfo{TurtleCommand::push, "[", 0, "remember the turtle's state"},
    TurtleCommandInfo{TurtleCommand::pop, "]", 0, "return to the state at the matching ["},
    TurtleCommandInfo{TurtleCommand::style, ";", 1, "paint following terminals in the style of that number; 0 = their own"},
    TurtleCommandInfo{TurtleCommand::layer, "z", 1, "raise following terminals by that many layers"},
    TurtleCommandInfo{TurtleCommand::fill, "fill", 3,
                      "fill following terminals with that red, green, blue; none = their own", true},
    TurtleCommandInfo{TurtleCommand::stroke, "stroke", 3,
                      "stroke following terminals with that red, green, blue; none = their own", true},
};

}  // namespace

std::string arity_text(const TurtleCommandInfo& command) {
    return std::to_string(command.arity) + (command.may_be_bare ? " or 0" : "");
}

std::span<const TurtleCommandInfo> turtle_commands() { return commands; }

const TurtleCommandInfo* find_turtle_command(std::string_view symbol) {
    const auto* found = std::ranges::find(commands, symbol, &TurtleCommandInfo::symbol);
    return found == commands.end() ? nullptr : found;
}

}  // namespace rinceau
