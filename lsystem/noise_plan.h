#pragma once
// Where a designer expects noise: windows turn a little in their places, petals swing about the middle of their ring,
// branches grow at other angles; what holds a facade together stays. Internal to the folder.

#include <vector>

#include "lsystem/expression_place.h"
#include "lsystem/grammar.h"
#include "lsystem/noise_form.h"

namespace rinceau {

struct NoisePlace {
    enum class How : unsigned char {
        in_expression,  ///< of the module at `position`
        before,         ///< a command of its own before `position`
        bracketed       ///< the same, in brackets with the symbol at `position`
    };
    NoiseKind kind = NoiseKind::angle;
    How how = How::in_expression;
    StringPlace string;
    int position = 0;
    int argument = 0;
};

/// For a grammar without noise. Each rule that repeats itself is looked at:
/// - Where the turtle keeps its heading from one to the next (a row), or comes around to it (a ring), the noise of angles
/// and
///   scales goes to each element on its own and does not add up; elements that are rows or rings themselves have none.
/// - Where it turns (a spiral, a branch of a tree), the step's last turn has it, and what follows goes along.
/// - A scale in the step has the noise of scales. Distances have noise in the steps, and between the middle of a ring and
///   its elements.
/// Nothing else is disturbed: the two turns of -(90) f(10) +(90) stay quarter turns.
std::vector<NoisePlace> noise_places(const Grammar& grammar);

}  // namespace rinceau
