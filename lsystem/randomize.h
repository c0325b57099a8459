#pragma once
// Random relatives of a grammar's picture: noise on its numbers, the same for the same seed (docs/editing.md).

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lsystem/edit_result.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// Standard deviations: not given = noise of that kind stays as it is, 0 = it is taken away.
struct RandomizeOptions {
    std::optional<double> angle;     ///< degrees
    std::optional<double> distance;  ///< share of the distance
    std::optional<double> scale;     ///< of the scale's natural logarithm, so that no scale is 0 or below
    std::vector<std::string> only;   ///< names or patterns (numbers.h); empty = where noise_plan.h puts it
    std::optional<std::uint64_t> seed;
};

/// Writes the noise into the grammar as normal(0, s). Earlier noise of a kind that is given is replaced: all of it, or with
/// `only` that of those numbers; a deviation of 0 gives back exactly the expressions from before. Throws InputError for
/// names that are not of an angle, distance or scale in a string, and for deviations below 0.
EditResult randomize(const Grammar& grammar, const RandomizeOptions& options);

/// The grammar without any noise that randomize() has put there.
Grammar without_noise(const Grammar& grammar);

}  // namespace rinceau
