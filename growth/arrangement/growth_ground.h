#pragma once
// An exemplar made ready for growth: what every step looks up.

#include <array>
#include <vector>

#include "growth/arrangement/arrange_options.h"
#include "growth/arrangement/element_arrangement.h"
#include "growth/arrangement/exemplar.h"

namespace rinceau {

/// The ring of an element of the exemplar, flat.
struct ReferenceRing {
    std::vector<Point> offsets;  ///< counter-clockwise
    std::vector<double> lengths;
    std::vector<int> symbols;
    std::vector<int> sub_ids;
    std::vector<std::array<int, 2>> steps;  ///< in columns and rows; only of a lattice
    std::vector<double> half_gap_cos;       ///< cosine of half the smaller angle to the places beside it
    std::vector<Point> outer_offsets;       ///< the neighbours' neighbours; only if two rings are compared
    std::vector<int> outer_symbols;
};

/// Refers to what it was made of.
struct GrowthGround {
    const Exemplar& exemplar;
    const ArrangeSurroundings& around;
    const ArrangeOptions& options;
    std::vector<ReferenceRing> rings;         ///< by element of the exemplar
    std::vector<Box> boxes;                   ///< of their outlines
    std::vector<int> usable;                  ///< elements
    std::vector<std::vector<int>> usable_of;  ///< by symbol
    std::vector<std::vector<double>> least;   ///< distance of centres by symbols, finite
    std::vector<double> least_of;             ///< the least of a symbol to any
    std::vector<double> reach_of;             ///< the largest of a symbol to any
    double reach = 0;                         ///< the largest of `least`
    double largest_radius = 0;                ///< of an element
    int sub_ids = 0;                          ///< one more than the largest
    bool by_lattice = false;                  ///< neighbours are told by lattice index
    bool exclusive = false;  ///< along a flow, of outlines that do not overlap: nothing may ever move into another one
    bool rigid = false;  ///< a regular pattern: what does not fit at a line is left out, and nothing is pushed aside for it
};

GrowthGround make_ground(const Exemplar& exemplar, const ArrangeSurroundings& around, const ArrangeOptions& options);

/// Angle that a ring has at `at`, in the modes that do not look for it: 0, or along the flow (section 5.3); of a flow
/// without forward and back, the one of two that goes with `hint`.
double ring_angle(const GrowthGround& ground, Point at, Complex hint);
/// Where the reference wants the neighbour in `place` to be, from a node at `at` that is turned by `angle`. Along a flow the
/// direction halfway counts: a gentle bend then has fewer faults than with the direction at the node.
Point ring_target(const GrowthGround& ground, int reference, int place, double angle, Point at);
/// The least distance of two kinds; of a seed of any kind, the least that the other has.
double least_distance(const GrowthGround& ground, int symbol, int other);
/// Is there a boundary line between, or is `to` outside the region?
bool is_barred(const GrowthGround& ground, Point from, Point to);

}  // namespace rinceau
