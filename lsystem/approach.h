#pragma once
// A string of modules cut into the ways to its symbols: in "[f(50) A] +(30) P(m-1)" the command f(50) leads to A and +(30)
// to P. Internal to the folder.

#include <string>
#include <vector>

#include "lsystem/grammar.h"

namespace rinceau {

/// Brackets are no commands here.
struct Approach {
    int symbol = -1;            ///< position of the symbol that is led to; -1 = none: commands behind the last symbol
    bool own = false;           ///< it is the production's own symbol, or there is none
    int ordinal = 1;            ///< among the approaches of the string to this symbol, from 1 ..
    int of = 1;                 ///< .. to this
    std::vector<int> commands;  ///< positions of the commands since the symbol before, or since the bracket was opened
};

/// In order of the string. `own_symbol` is that of the production whose successor the string is; empty for others.
std::vector<Approach> approaches_of(const std::vector<ModuleTemplate>& string, const std::string& own_symbol);

/// Positions of all commands and symbols before `position` that the turtle has not returned from when it is there.
std::vector<int> way_to(const std::vector<ModuleTemplate>& string, int position);

/// + and -: the angle's sign; 0 for anything else.
int turn_sign(const ModuleTemplate& module);

}  // namespace rinceau
