#pragma once
// Random relatives of a grammar's picture: noise on its numbers, the same for the same seed (docs/editing.md).

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lsystem/edit_result.h"
#include "lsystem/grammar.h"
#include "lsystem/noise.h"
#include "lsystem/numbers.h"

namespace rinceau {

/// Spreads (noise.h): not given = noise of that kind stays as it is, 0 = it is taken away.
struct RandomizeOptions {
    std::optional<double> angle;     ///< degrees
    std::optional<double> distance;  ///< share of the distance
    std::optional<double> scale;     ///< of the scale's natural logarithm, so that no scale is 0 or below
    std::vector<std::string> only;   ///< names or patterns (numbers.h); empty = where noise_plan.h puts it
    std::optional<std::uint64_t> seed;
    NoiseDistribution angle_distribution = NoiseDistribution::normal;
    NoiseDistribution distance_distribution = NoiseDistribution::normal;
    NoiseDistribution scale_distribution = NoiseDistribution::normal;
    std::map<std::string, Noise> named;  ///< numbers with noise of their own, whatever their kind has
};

/// Writes the noise into the grammar as normal(0, s) or uniform(-s, s). Earlier noise of a kind that is given is replaced:
/// all of it, or with `only` that of those numbers; a spread of 0 gives back exactly the expressions from before. Throws
/// InputError for names that are not of an angle, distance or scale in a string, and for spreads below 0.
EditResult randomize(const Grammar& grammar, const RandomizeOptions& options);

/// May the number have noise of its own: is it an angle, a distance or a scale that is written in a string?
bool takes_noise(const GrammarNumber& number);

/// The noise on a number of the grammar; nothing if it has none.
std::optional<Noise> noise_on(const Grammar& grammar, const GrammarNumber& number);

/// The noise that the grammar has anywhere, by kind; of several that differ the widest.
struct NoiseInGrammar {
    std::optional<Noise> angle, distance, scale;
};
NoiseInGrammar noise_in(const Grammar& grammar);

/// The grammar without any noise that randomize() has put there.
Grammar without_noise(const Grammar& grammar);

}  // namespace rinceau
