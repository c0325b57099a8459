#pragma once
// The turtle's commands as data (Stava et al. 2010, Table 1, with mirror, style and layer added): symbol, arity, help.

#include <span>
#include <string_view>

namespace rinceau {

enum class TurtleCommand : unsigned char { left, right, forward, scale, mirror, push, pop, style, layer };

struct TurtleCommandInfo {
    TurtleCommand command;
    std::string_view symbol;  ///< "+" "-" "f" "*" "|" "[" "]" ";" "z"
    int arity;                ///< number of arguments
    std::string_view help;    ///< one line
};

/// +(a) turn left a degrees, -(a) turn right, f(d) move d times the current scale along the heading, *(s) multiply the
/// scale by s > 0, | mirror what follows about the heading, [ push, ] pop, ;(n) following terminals take style n (0 = their
/// own), z(k) raise following terminals by k layers (k may be negative; added up).
std::span<const TurtleCommandInfo> turtle_commands();

/// nullptr if `symbol` is no turtle command.
const TurtleCommandInfo* find_turtle_command(std::string_view symbol);

}  // namespace rinceau
