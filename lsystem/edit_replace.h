#pragma once
// Replacing what symbols stand for (Stava et al. 2010, section 6, Figure 11): a terminal or a non-terminal by another
// symbol, by a drawing, or by a symbol of another grammar.

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "lsystem/derive.h"
#include "lsystem/edit_result.h"
#include "lsystem/fit_box.h"
#include "lsystem/grammar.h"
#include "lsystem/grammar_names.h"
#include "scene/element.h"

namespace rinceau {

/// Modules of the grammar that is edited: a symbol ("Leaf", "Ring(8)") or a string; nothing = what is replaced is erased.
struct OwnModules {
    ModuleTemplates string;
};
/// A string of another grammar, which is resolved (resolve_uses.h).
struct OtherGrammar {
    Grammar grammar;
    ModuleTemplates string;  ///< empty = its axiom, whose symbol in the edited grammar gets `name`
    std::string name;
};
struct OtherDrawing {
    std::vector<Element> elements;
    std::string name;  ///< of its symbol in the edited grammar
};

struct Replacement {
    std::string symbol;
    std::variant<OwnModules, OtherGrammar, OtherDrawing> with;
    std::string label;  ///< what `with` is called in messages: "leaf.svg", "vine.lsys#Grapes"
};

struct ReplaceOptions {
    /// The new thing's box is laid into the box of what the symbol draws, in the symbol's own frame: centre on centre,
    /// heading kept, scaled evenly. A symbol that stands with several numbers is measured with each of them. With `none`
    /// nothing is scaled: symbols keep their frames, the centre of a drawing comes to the centre of the place.
    ReplaceFit fit = ReplaceFit::inside;
    double turn = 0;                   ///< degrees counter-clockwise, before the fit
    std::vector<std::vector<int>> at;  ///< addresses; only what stands there is replaced, by exceptions. Empty = everywhere
    bool restyle = false;              ///< paint what comes from elsewhere in the style that is in force where it is put
    bool keep = false;                 ///< keep what nothing uses any more
    DeriveOptions derive;              ///< how far symbols are expanded when they are measured
    std::function<Grammar(const Grammar&)> resolve;  ///< resolves `use`, if the grammar has any
};

/// Replaces all symbols at once, so that A by B and B by A swaps. Everywhere: in the axiom, in productions of other symbols
/// and in exceptions; a symbol's own productions go away with it. Arguments are passed on to a symbol that takes as many,
/// else it gets those with which it stands in its own grammar. Modules that follow find the turtle where they found it
/// before: what the old one moves is still moved. Addresses keep their modules; exceptions below what is replaced are
/// dropped. What only the old thing used is removed. Guarantee: the result derives and draws. Throws InputError for an
/// unknown symbol, one that stands nowhere, a drawing without elements, a replacement that would hold itself, a move that
/// depends on random numbers, a symbol that is a context; and as interpret().
EditResult replace_symbols(const Grammar& grammar, const std::vector<Replacement>& replacements,
                           const ReplaceOptions& options = {});

}  // namespace rinceau
