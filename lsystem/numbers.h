#pragma once
// The numbers of a grammar by name: what can be listed, turned and typed in (docs/editing.md).
//
// A name says where a number stands and what it does: "Row.count", "Ring.turn", "axiom.Hand.distance", "style1.opacity",
// "bay" for a constant. It depends on the symbols about it, not on any value: setting a number, or changing other
// productions, renames nothing.

#include <optional>
#include <string>
#include <vector>

#include "lsystem/expression_place.h"
#include "lsystem/grammar.h"

namespace rinceau {

enum class NumberKind : unsigned char { count, angle, length, scale, style_choice, layer, share, seed, other };

/// Where a number is written, and as what: written = slope * value + offset.
struct NumberSlot {
    enum class In : unsigned char { expression, stroke_width, fill_opacity, stroke_opacity, opacity, canvas, seed };
    In in = In::expression;
    ExpressionPlace place;  ///< In::expression
    int index = 0;          ///< of the style; of the canvas's x, y, width, height
    double slope = 1;
    double offset = 0;
    friend constexpr bool operator==(const NumberSlot&, const NumberSlot&) = default;
};

/// Which list a number belongs to: the first says what a picture's rules are about; the others follow if there is room.
enum class NumberRank : unsigned char { rule, part, axiom, style, exception, detail, hidden };

struct GrammarNumber {
    std::string name;
    double value = 0;
    NumberKind kind = NumberKind::other;
    std::string unit;  ///< "degrees", or empty
    std::string help;  ///< what it means, in words
    bool whole = false;
    double low = 0, high = 0;  ///< range of values that make sense; both may be infinite
    NumberRank rank = NumberRank::detail;
    std::vector<NumberSlot> slots;         ///< setting the number writes all of them
    std::vector<std::string> parts;        ///< a number of several that differ: setting it sets these instead
    std::string written;                   ///< the expression, where it is more than a number
    int constant = -1;                     ///< index of the constant that it is written as; -1 = none ..
    std::optional<ExpressionPlace> alias;  ///< .. and where the constant's name stands
};

/// All numbers of the grammar, those of rank `hidden` too, which are other ways to say what others say. The order is that of
/// the text within a rank. Names are unique.
std::vector<GrammarNumber> grammar_numbers(const Grammar& grammar);

/// Does the pattern fit the name? '*' stands for any characters.
bool fits_name(const std::string& pattern, const std::string& name);

}  // namespace rinceau
