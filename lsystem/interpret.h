#pragma once
// Turtle interpretation: from the grammar (or a string) to placed terminals.

#include <functional>
#include <optional>
#include <vector>

#include "geometry/similarity.h"
#include "lsystem/derive.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// Where a module stands in the grammar: position in a production's successor, or in the axiom (production -1) or in an
/// exception's successor (production -2).
struct Occurrence {
    int production = -1;
    int position = 0;
    friend constexpr bool operator==(const Occurrence&, const Occurrence&) = default;
};

/// Colours that take the place of a style's solid paints; what paints nothing, or a gradient, stays as it is.
struct Repaint {
    std::optional<Color> fill;
    std::optional<Color> stroke;
    friend constexpr bool operator==(const Repaint&, const Repaint&) = default;
};

/// One drawn terminal. Order in a list of placements: paint order, that is stable by (layer, order of derivation).
struct Placement {
    int terminal = 0;  ///< index into Grammar::terminals
    int style = 0;     ///< style number in force; 0 = the terminal's own
    Repaint repaint;   ///< by the commands fill and stroke; verbatim fragments ignore it
    int layer = 0;
    Similarity pose;                ///< terminal frame -> scene
    std::vector<int> address;       ///< of the terminal (derive.h); empty unless InterpretOptions::addresses
    int order = 0;                  ///< index in order of derivation, before layers are sorted
    std::vector<Occurrence> trail;  ///< the occurrences from the axiom down to the terminal, self-recursion of a production
                                    ///< left out; empty unless InterpretOptions::trails
    int production = -1;            ///< whose successor placed it, or the module that an exception replaces; -1 = the axiom
};

struct InterpretOptions {
    DeriveOptions derive;
    bool addresses = false;
    bool trails = false;
};

/// Derives and interprets in one stream, with homomorphisms: what they make stands below the address of the module it stands
/// for. Memory is proportional to depth and to the placements. The turtle starts at the
/// origin, heading +y, scale 1, layer 0. Symbols that are neither commands nor terminals draw nothing.
/// Throws as derive(), and InputError for ] without [, for a scale that is not positive, and unknown style numbers.
std::vector<Placement> interpret(const Grammar& grammar, const InterpretOptions& options = {},
                                 const Progress& progress = {});

/// The same without a list: `visit` gets each placement in order of derivation, before layers are sorted. The reference
/// holds during the call only.
void visit_placements(const Grammar& grammar, const InterpretOptions& options,
                      const std::function<void(const Placement&)>& visit, const Progress& progress = {});

/// What happens to the turtle, one after the other.
enum class TurtleEventKind : unsigned char {
    turned,  ///< or scaled, or mirrored: all but its place
    moved,
    pushed,
    popped,
    placed,  ///< a terminal
    opened,  ///< the modules of a symbol begin; what a production makes of its own symbol again goes on in the same ones
    closed,
};

/// References hold during the call only.
struct TurtleEvent {
    TurtleEventKind kind = TurtleEventKind::turned;
    const Similarity& pose;                ///< the turtle's, afterwards
    const Placement* placement = nullptr;  ///< of placed
};

/// The same derivation with the turtle's whole way, for interpretations elsewhere than in the plane. Brackets and symbols
/// nest each by themselves, but a symbol's modules may end outside of a bracket that they opened. Throws as interpret().
void visit_turtle(const Grammar& grammar, const InterpretOptions& options,
                  const std::function<void(const TurtleEvent&)>& visit, const Progress& progress = {});

}  // namespace rinceau
