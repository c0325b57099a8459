#pragma once
// A finished description of a drawing: rules as a grammar that redraws it, and what it costs to read.

#include <optional>
#include <vector>

#include "analyzer/grammar_bits.h"
#include "analyzer/openings.h"
#include "analyzer/overlaps.h"
#include "analyzer/residuals.h"
#include "analyzer/to_grammar.h"

namespace rinceau {

/// The drawing in one reading: with these looks. Outlives its descriptions.
struct Drawing {
    const Scene& scene;
    const Instancing& instancing;
    const Overlaps& overlaps;
    double diagonal;
    double flat_bits;  ///< of the flat list, the same for all readings
    int kinds;         ///< of things, as a reader counts them: named_kinds
};

struct Description {
    const Drawing* reading = nullptr;
    OrderedRules ordered;
    WrittenGrammar written;
    Grammar exact;  ///< with residuals, before layers
    std::vector<double> deviation;  ///< by leaf, before residuals
    std::vector<double> left_over;  ///< by leaf, where groups are moved
    std::vector<MovedGroup> groups;
    DescriptionBits bits;  ///< of `exact`
    double tolerance = 0;
    double cost =
        0;  ///< what decides between descriptions: bits, and what each production and each kind of thing costs a reader
    ConvincingCost if_longer, if_not_longer;  ///< of its opening
};

/// How far an element may miss its place, a scene length: a tenth of a pixel of a picture 900 pixels wide.
double exact_tolerance(const Drawing& drawing);

/// Nothing if the reading's colours cannot be brought into the rules. `tolerance` is only noted.
std::optional<Description> describe(const Drawing& drawing, RuleSet rules, double tolerance);

/// Bits of another grammar of the same rules, with layers for instance.
DescriptionBits bits_of(const Description& description, const Grammar& grammar);

/// No rules: every element stands in the axiom.
Description flat_description(const Drawing& drawing);

}  // namespace rinceau
