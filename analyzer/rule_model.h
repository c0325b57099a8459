#pragma once
// What the rule finder works on (docs/analysis.md, 4): parts, items and rules.
// A part is a symbol with a frame of its own: a look of the drawing, or what a rule makes with a given count. An item is
// one place where a part stands. Rules turn items into members of new items until few are left: these form the axiom.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "analyzer/instancing.h"
#include "analyzer/spiral_law.h"
#include "geometry/similarity.h"

namespace rinceau {

enum class RuleKind : std::uint8_t {
    sequence,  ///< r1: [A] T P(m-1), constant step T
    ring,      ///< a sequence that closes
    linear,    ///< r1 with t(m) = t0 + tDelta m in alpha and beta (eq. 4)
    group,     ///< several parts in fixed positions (r1 and r2 for P(1), merged: section 5.7)
    branch,    ///< r3 and r4: R(m) -> members [T1 R(m-1)] .. [Tk R(m-1)], R(0) -> leaves
    spiral,     ///< members about a pivot, at distances that are powers of an index
    family     ///< rows of one sequence rule, each with the same number of repetitions more or fewer: Q(k) -> [P(k)] T Q(k-1)
};

/// A member of a part, in the part's frame.
struct Child {
    int part = 0;
    Similarity pose;
};

struct Rule {
    RuleKind kind = RuleKind::sequence;
    int repeated = -1;       ///< part that a sequence, ring or linear rule repeats
    Similarity step;         ///< from one repetition to the next; linear: the first one
    double turn_change = 0;  ///< linear: what alpha and beta of the step grow by from one repetition to the next
    double spin_change = 0;
    double advance_change = 0;  ///< linear: what its length grows by, in sizes of the first repetition ..
    double advance_factor = 1;  ///< .. and is multiplied with each time
    double size_change = 0;     ///< linear: repetition k is 1 + k * size_change times as large as the first
    bool upright = false;  ///< linear: members on a circle that keep their heading; the step turns nothing, and alpha and
                           ///< beta change by opposite amounts
    Point seat;                 ///< linear: of the repeated part's frame; steps lead from seat to seat, and sizes are about it
    std::vector<Child> members;  ///< group: relative to the first, whose pose is the identity; branch: what stands at every
                                 ///< node, in the node's frame, possibly nothing (a drawing that consists of small copies
                                 ///< of itself)
    std::vector<Similarity> steps;  ///< branch: from a node to each of those that grow from it, at least one
    std::vector<Child> leaves;      ///< branch: what stands at depth 0, in the node's frame, possibly nothing
    SpiralLaw spiral;               ///< spiral
};

struct Part {
    int look = -1;                ///< a look of the drawing, or
    int shape = -1;               ///< of a look: equal for looks of equal outline, whose items have comparable poses
    int rule = -1;                ///< a rule with this
    int count = 1;                ///< number of repetitions (group: 1, branch: depth, at least 1)
    std::vector<Child> children;  ///< in order of derivation; origin = mean of their origins, first child unturned, unscaled
    Similarity node;              ///< branch: frame of the lowest node -> part frame
    SymmetryGroup symmetry;
    double radius = 1;  ///< of a circle about the origin that holds the part, roughly; own units
    int leaves = 1;
    std::optional<Similarity> pivot;  ///< part frame: where the part is written from (unit linear part), if not at its first child
};

struct Item {
    int part = 0;
    Similarity pose;           ///< part frame -> scene
    /// Items, in the order of the part's children; -1: this child is missing; an item of another part: it stands in for the
    /// child, wherever it lies (the grammar says both in an exception).
    std::vector<int> members;
    int element = -1;          ///< scene element of a look
    int first = 0;             ///< lowest scene element below, by paint order
    bool alive = true;         ///< not yet a member of another item
};

struct RuleSet {
    std::vector<Part> parts;
    std::vector<Rule> rules;
    std::vector<Item> items;
};

/// Poses of the repetitions in the frame of the first one: identity, T, T^2, .. (linear: products of changing steps).
std::vector<Similarity> repetition_poses(const Rule& rule, int count);

/// The step of a linear rule from the seat of repetition k to that of k + 1, k from 0, without the change of size.
Similarity linear_step(const Rule& rule, int k);

/// Is child k of the item's part where the part has it? Not if it is missing or something else stands in for it.
bool is_regular(const RuleSet& rules, const Item& item, std::size_t k);

/// The items that the axiom lists: alive, in order of their lowest element.
std::vector<int> root_items(const RuleSet& rules);

/// Elements below an item, in order of derivation; none for what is missing.
std::vector<int> elements_below(const RuleSet& rules, int item);

}  // namespace rinceau
