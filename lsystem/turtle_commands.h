#pragma once
// The turtle's commands as data (Stava et al. 2010, Table 1, with mirror, style, layer and colours added): symbol, arity,
// help.

#include <span>
#include <string>
#include <string_view>

namespace rinceau {

enum class TurtleCommand : unsigned char { left, right, forward, scale, mirror, push, pop, style, layer, fill, stroke };

struct TurtleCommandInfo {
    TurtleCommand command;
    std::string_view symbol;   ///< "+" "-" "f" "*" "|" "[" "]" ";" "z" "fill" "stroke"
    int arity;                 ///< number of arguments
    std::string_view help;     ///< one line
    bool may_be_bare = false;  ///< without arguments it has a meaning of its own
};

constexpr bool takes(const TurtleCommandInfo& command, std::size_t arguments) {
    return arguments == static_cast<std::size_t>(command.arity) || (command.may_be_bare && arguments == 0);
}

/// "3", or "3 or 0": the numbers of arguments that it takes, for messages.
std::string arity_text(const TurtleCommandInfo& command);

/// +(a) turn left a degrees, -(a) turn right, f(d) move d times the current scale along the heading, *(s) multiply the
/// scale by s > 0, | mirror what follows about the heading, [ push, ] pop, ;(n) following terminals take style n (0 = their
/// own), z(k) raise following terminals by k layers (k may be negative; added up), fill(r, g, b) and stroke(r, g, b)
/// repaint the fills and strokes of following terminals (0 to 255; without arguments the style's own again).
std::span<const TurtleCommandInfo> turtle_commands();

/// nullptr if `symbol` is no turtle command.
const TurtleCommandInfo* find_turtle_command(std::string_view symbol);

}  // namespace rinceau
