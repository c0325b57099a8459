#pragma once
// What a string of modules draws and where it takes the turtle, by itself; and where a symbol stands in a derivation.

#include <string>
#include <vector>

#include "geometry/box.h"
#include "geometry/similarity.h"
#include "lsystem/derive.h"
#include "lsystem/grammar.h"
#include "lsystem/grammar_names.h"
#include "lsystem/interpret.h"

namespace rinceau {

/// What decides on the paints of terminals besides their own styles.
struct Colouring {
    int style = 0;
    Repaint repaint;
    friend constexpr bool operator==(const Colouring&, const Colouring&) = default;
};

struct Measure {
    Box box;  ///< of outlines with half their stroke's width, in the turtle's frame before the string; empty = draws nothing
    Similarity move;      ///< from the turtle's frame before the string to that behind it
    Colouring colouring;  ///< in force behind it
    int layer = 0;
    int outlines = 0;
};

/// Draws the string alone, without the grammar's exceptions. Its arguments may use constants. Throws as interpret().
Measure measure(const Grammar& grammar, const ModuleTemplates& string, const DeriveOptions& options = {});

/// The box of what is seen of elements: outlines and half their strokes' widths, corners of strokes left out.
Box visible_box(const std::vector<Element>& elements);

/// Which of a grammar's strings: the axiom, a production's or an exception's successor.
struct WrittenString {
    enum class Kind : unsigned char { axiom, production, exception };
    Kind kind = Kind::axiom;
    int index = 0;
    friend constexpr auto operator<=>(const WrittenString&, const WrittenString&) = default;
};

/// One module of the derivation.
struct SymbolInstance {
    WrittenString string;  ///< where it is written ..
    int position = 0;    ///< .. as the so manieth module
    std::vector<int> address;
    std::vector<double> arguments;
    bool measured =
        true;  ///< false: it stands in the drawing only (a homomorphism has put it there), its arguments are unknown
    Colouring colouring;  ///< in force before it
};

/// Where `symbol` stands in the derivation of a grammar when no symbol of `stopped` is rewritten (`symbol` is one of them),
/// in order of derivation: what the symbols of `stopped` put in their own places does not count. Throws as interpret().
std::vector<SymbolInstance> find_instances(const Grammar& grammar, const std::string& symbol, const std::set<std::string>& stopped,
                                     const DeriveOptions& options = {});

}  // namespace rinceau
