#pragma once
// Which rule comes first: the four weights of the importance function, and the function itself (Stava et al. 2010, section
// 5.4, eq. 5).

#include <cstdint>

namespace rinceau {

/// 0..4 each, 1 = neutral: they steer which structure is preferred. Whatever they are, with Objective::bits a rule must save
/// bits at neutral weights to be accepted at all; with low weights rules that would save bits may stay away.
struct ImportanceWeights {
    double count = 1;       ///< w_n: structures that repeat often
    double nearness = 1;    ///< w_h: near elements first
    double similarity = 1;  ///< w_phi: small deviations first
    double length = 1;      ///< w_l: long sequences first
};

/// What decides on the next rule, and whether there is one.
enum class Objective : std::uint8_t {
    bits,  ///< what it saves in bits, weighted; only what saves bits and is no chance
    paper  ///< importance(); everything that repeats, until nothing is left to join
};

/// The values of eq. 5 for one hypothesis.
struct ImportanceTerms {
    double elements = 0;    ///< n: in all its sequences
    double nearness = 0;    ///< h: 1 = they touch, 0 = as far from each other as two elements of the drawing can be
    double similarity = 0;  ///< phi: 1 = copies of each other in exactly equal steps, 0 = not copies
    double length = 0;      ///< l: elements in a sequence, on average
};

/// w = w_n n + w_h h + w_phi phi + w_l l, with n and l as shares of `largest`.
double importance(const ImportanceTerms& terms, const ImportanceTerms& largest, const ImportanceWeights& weights);

/// No hypothesis is more important.
double greatest_importance(const ImportanceWeights& weights);

}  // namespace rinceau
