#pragma once
// The way from the axiom down to one drawn element, and all that stands along it: what a click on a drawing selects.

#include <optional>
#include <string>
#include <vector>

#include "geometry/progress.h"
#include "geometry/similarity.h"
#include "lsystem/derive.h"
#include "lsystem/expression_place.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// One repetition of a rule that repeats itself: its elements are among [first, last) in order of derivation.
struct SequencePart {
    Similarity pose;  ///< of the turtle at the first module in it that draws
    int first = 0;
    int last = 0;
};

/// A module that was replaced on the way, or at the end the drawn one. Modules of a production's own symbol that stand alone
/// in it (P(m) -> [A] f(1) P(m-1)) are not on the way: the whole sequence is one module P, with parts. Where there are
/// several (a tree) each branch is a module that `branches`.
struct PathModule {
    std::string symbol;             ///< empty for the axiom, which comes first
    std::vector<double> arguments;  ///< with which it stands; none for what an exception replaces
    StringPlace string;             ///< where it is written ..
    int position = -1;              ///< .. as the so manieth module
    int production = -1;            ///< that replaces it; -1 = none
    int exception = -1;             ///< that replaces it; -1 = none
    bool branches = false;          ///< it continues a rule of its own symbol, as one of several branches
    std::vector<int> address;       ///< (derive.h); empty for the axiom and for branches
    Similarity pose;                ///< of the turtle where it stands
    Similarity after;               ///< of the turtle behind all that it makes
    int first = 0;                  ///< what it draws: the elements [first, last) in order of derivation
    int last = 0;
    std::vector<SequencePart> parts;  ///< if its rule repeats itself, else empty
    int part = -1;                    ///< in which part of the module above it stands; -1 = that has none
    int count = 1;                    ///< modules of this symbol in the whole derivation, continuations not counted
};

/// An element: by its place in order of derivation (Placement::order), or the first whose address begins so.
struct ElementQuery {
    int order = -1;
    std::vector<int> address;
};

/// The way to the element; empty if there is none. Throws as interpret().
std::vector<PathModule> derivation_path(const Grammar& grammar, const ElementQuery& element,
                                        const DeriveOptions& options = {}, const Progress& progress = {});

/// The pose of path[module] on the way to the element of that order, without deriving what comes behind it; nothing if there
/// is none. Throws as interpret().
std::optional<Similarity> pose_on_path(const Grammar& grammar, int order, std::size_t module,
                                       const DeriveOptions& options = {});

}  // namespace rinceau
