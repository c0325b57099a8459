#pragma once
// Turtle commands for a similarity, with as few digits as the drawing allows (docs/analysis.md, 7).

#include <string>
#include <vector>

#include "geometry/similarity.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// How far the numbers of a move may be off, as lengths in the turtle's units and angles in radians.
struct MoveSlack {
    double length = 0;
    double turn = 0;   ///< of what comes after the first turn
    double spin = 0;   ///< of what stands at the end of the move
    double scale = 0;  ///< relative
};

/// The shortest decimal number within `slack` of `value`; exact (shortest round trip) for slack 0.
double tidy(double value, double slack);

ModuleTemplate command(std::string symbol);
ModuleTemplate command(std::string symbol, double argument);
/// A module whose single argument is given as the text of an expression.
ModuleTemplate command(std::string symbol, const std::string& expression);

/// "+(degrees)" or "-(degrees)"; nothing if the angle is within the slack of 0.
void append_turn(std::vector<ModuleTemplate>& modules, double angle, double slack);

/// +(turn) f(advance) *(scale) +(spin) | ; neutral commands are left out, and a move straight back is f(-d). Where that
/// reads shorter, first along the heading, then to the right: f(y) -(90) f(x) *(scale) +(90 + spin) |.
void append_move(std::vector<ModuleTemplate>& modules, const Similarity& move, const MoveSlack& slack);

/// "[" modules "]"
std::vector<ModuleTemplate> bracketed(std::vector<ModuleTemplate> modules);

}  // namespace rinceau
