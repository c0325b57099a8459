#pragma once
// Which numbers of a grammar move, turn and scale a module of its derivation.

#include <vector>

#include "lsystem/derivation_path.h"
#include "lsystem/numbers.h"

namespace rinceau {

/// Numbers that stand in one string on the way to a module.
struct NumberGroup {
    std::size_t level = 0;  ///< of the path: the module that they lead to
    bool step = false;      ///< they lead from one part of a sequence to the next, not from its beginning to the module
    std::vector<GrammarNumber> numbers;  ///< angles, lengths, scales and arguments
};

/// Those that lead to path[level], then those that lead to the modules above it; the step of a sequence in which a module is
/// not the first comes before the way within a part of it. The turn of a ring that is closed is left out: it follows the
/// count. `numbers` are those of `grammar` that may be used; hidden ones only as names of constants, for which the constant's
/// own number is given. Groups without numbers are left out.
std::vector<NumberGroup> moving_numbers(const Grammar& grammar, const std::vector<GrammarNumber>& numbers,
                                        const std::vector<PathModule>& path, std::size_t level);

/// Those of `numbers` that are angles on the way to path[level] in its string, hidden ones, too.
std::vector<GrammarNumber> angles_before(const Grammar& grammar, const std::vector<GrammarNumber>& numbers,
                                         const PathModule& module);

}  // namespace rinceau
