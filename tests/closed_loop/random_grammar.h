#pragma once
// Grammars drawn at random whose structure a person would see: elements apart from each other, steps clearly the nearest.

#include <cstdint>
#include <string>
#include <vector>

#include "lsystem/grammar.h"

namespace rinceau::test {

/// One production as it was put in. Angles in degrees, lengths in the frame of the repeated symbol.
struct ExpectedRule {
    std::string kind;        ///< "sequence", "ring", "linear", "group"
    int count = 0;           ///< repetitions, or members of the group
    double turn = 0;         ///< before the advance ..
    double advance = 0;
    double scale = 1;
    double spin = 0;         ///< .. and after it; ring: 360 / count
    double turn_change = 0;  ///< linear
    double spin_change = 0;
    /// The repeated symbol has no symmetry, so that turn and spin have one value only (up to reversal of the sequence).
    bool unique = false;
};

struct KnownGrammar {
    Grammar grammar;                  ///< the axiom is one symbol
    std::vector<ExpectedRule> rules;  ///< innermost first
    int elements = 0;
    int terminals = 0;
};

enum class SampleKind : unsigned char { sequence, linear, ring, grid, group, hierarchy };

/// The same grammar for the same seed and kind. A group of 2 to 4 terminals is repeated in a sequence or ring; a hierarchy
/// has two or three levels of sequences and rings.
KnownGrammar random_known_grammar(SampleKind kind, std::uint64_t seed);

}  // namespace rinceau::test
