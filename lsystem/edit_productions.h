#pragma once
// Productions added, removed, moved and renamed.

#include <string>
#include <vector>

#include "lsystem/edit_replace.h"
#include "lsystem/edit_result.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// What a new production looks like: nothing at all, elements side by side, elements around a point, a tree, the elements
/// on top of each other.
enum class ProductionShape : unsigned char { empty, sequence, ring, branching, group };

struct AddProductionOptions {
    ProductionShape shape = ProductionShape::sequence;
    std::string symbol;  ///< of the new production; a number behind it if it is taken; empty = after the shape
    std::vector<std::string> elements;  ///< what it repeats or holds; empty = the first symbol that has a drawing
    int before = -1;                    ///< index of the production that it is put before; -1 = behind all
    bool in_axiom = true;               ///< and one use of it in brackets behind the axiom, so that it is seen
};

/// Distances suit the size of the elements: they do not overlap, but for a group. Throws InputError for unknown elements
/// and names that are none, and as interpret() if the elements cannot be drawn.
EditResult add_production(const Grammar& grammar, const AddProductionOptions& options);

/// Why the production cannot be removed by itself: it is the only one of a symbol that is used and has no drawing. Names
/// where it is used. Empty = it can.
std::string reason_to_keep(const Grammar& grammar, int production);

/// Throws InputError with reason_to_keep(). With `uses` the symbol goes away wherever it stands (replace_symbols() by
/// nothing: what follows stays where it is), with all its productions and what only they used; throws as that.
EditResult remove_production(const Grammar& grammar, int production, bool uses = false, const ReplaceOptions& options = {});

/// `to` = its index afterwards.
EditResult move_production(const Grammar& grammar, int production, int to);

/// The lines before it in the text, without '#'.
EditResult comment_production(const Grammar& grammar, int production, const std::string& comment);

/// Everywhere. Throws InputError if `to` is no name, a command, a word of the language or taken, or if `from` is not the
/// grammar's own.
EditResult rename_symbol(const Grammar& grammar, const std::string& from, const std::string& to);

}  // namespace rinceau
