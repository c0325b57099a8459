#pragma once
// What the turtle remembers, handed on as an argument: for programs whose turtle does not remember it. Internal to the
// folder.

#include <optional>
#include <string>

#include "lsystem/grammar.h"

namespace rinceau {

enum class TurtleMemory : unsigned char {
    style,  ///< ;(n): what is drawn has the style's number as its last argument, 0 = the terminal's own
    scale,  ///< *(s): what is drawn has the scale as its last argument, f(d) is multiplied by it
};

/// A grammar that draws the same without the command: every symbol has one more argument, the last. Nothing if it cannot be
/// said by arguments: what a symbol leaves behind is needed by what stands after it, or brackets are not closed where they
/// are opened. Not for grammars with exceptions.
std::optional<Grammar> carried(const Grammar& grammar, TurtleMemory memory);

/// Does the command occur at all?
bool remembers(const Grammar& grammar, TurtleMemory memory);

}  // namespace rinceau
