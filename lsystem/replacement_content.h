#pragma once
// The new thing of a replacement brought into the grammar. Internal to the folder.

#include <optional>

#include "lsystem/edit_replace.h"

namespace rinceau {

struct Content {
    ModuleTemplates string;         ///< in the grammar; a single symbol, or nothing
    std::set<std::size_t> arities;  ///< of its productions, if it is a symbol that takes numbers of its own choice
    bool given_arguments = false;   ///< they were written; else `string` has those of its own grammar
    bool foreign = false;           ///< a drawing or from another grammar: it keeps its own colours
    int outlines = 0;               ///< of a drawing
    double scale = 1;               ///< of a drawing, by which it has been laid into its place
};

/// The grammar with the content of every replacement. `places[i]`: the box that a drawing is laid into, in the frame of what
/// it replaces; empty = its centre comes to the turtle.
struct WithContents {
    Grammar grammar;
    std::vector<Content> contents;
};
WithContents with_contents(const Grammar& grammar, const std::vector<Replacement>& replacements,
                           const std::vector<Box>& places, const ReplaceOptions& options);

}  // namespace rinceau
