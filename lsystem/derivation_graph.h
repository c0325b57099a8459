#pragma once
// The derivation as nested parts, equal ones once: what a drawing with definitions and instances needs.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/similarity.h"
#include "lsystem/derive.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// A terminal as it is painted.
struct GraphLook {
    int terminal = 0;  ///< index into Grammar::terminals
    int style = 0;     ///< number of the style in force, 0 = the terminal's own
    int fill = -1;     ///< 0xRRGGBB that the command fill has set, -1 = none
    int stroke = -1;   ///< the same of the command stroke
    friend constexpr auto operator<=>(const GraphLook&, const GraphLook&) = default;
};

/// The style that a look is painted in.
Style look_style(const Grammar& grammar, const GraphLook& look);

/// A look or another part, placed in the frame of the part that it belongs to.
struct PartItem {
    bool is_look = false;
    int index = 0;  ///< into DerivationGraph::looks or parts
    Similarity pose;
    int layer = 0;  ///< above the layer at the beginning of the part
};

/// What one module becomes. Modules of a production's own symbol that stand alone in it (P(m) -> [A] f(1) P(m-1)) continue
/// the part, so that a sequence is one part; where there are several (a tree), each is a part of its own.
struct GraphPart {
    std::string symbol;            ///< of the module; empty for the axiom
    std::vector<PartItem> items;   ///< in order of derivation, none of them empty
    std::uint64_t placements = 0;  ///< looks in all
};

/// Equal parts of equal symbols are one part. Parts come before the parts that use them; the last one is the axiom.
struct DerivationGraph {
    std::vector<GraphLook> looks;
    std::vector<GraphPart> parts;
};

/// Nothing if a production opens a bracket that another one closes: then what follows a part does not depend on its pose
/// alone. Throws as interpret(). Takes the time of two derivations and memory for the parts only.
std::optional<DerivationGraph> derivation_graph(const Grammar& grammar, const DeriveOptions& options = {});

}  // namespace rinceau
