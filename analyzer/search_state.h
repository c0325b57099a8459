#pragma once
// What the search for rules knows at one moment: the rules so far, who is alive, and what things cost in bits.

#include <map>
#include <memory>
#include <vector>

#include "analyzer/pose_grid.h"
#include "analyzer/rule_model.h"

namespace rinceau {

/// What it costs to write one item of a part flat (docs/analysis.md, 4.3).
struct PartCost {
    double place_bits = 0;          ///< one coordinate, to the tolerance, anywhere in the drawing
    double angle_bits = 0;          ///< empirical entropy of the orientations in this part
    double scale_bits = 0;          ///< ... of the sizes
    double item_bits = 0;           ///< all: two coordinates, angle, scale, which part
    double size = 1;                ///< geometric mean of the items' scales
    double neighbour_distance = 1;  ///< median distance of an item to the nearest other one of the part
};

struct SearchState {
    RuleSet rules;
    PoseTolerance tolerance;
    double diagonal = 1;                    ///< of the drawing
    double neighbour_distance = 1;          ///< median distance of an element to the nearest other one
    std::vector<std::vector<int>> members;  ///< living items by part, rising
    std::vector<PartCost> costs;            ///< by part

    const Part& part(int p) const { return rules.parts[static_cast<std::size_t>(p)]; }
    const Item& item(int i) const { return rules.items[static_cast<std::size_t>(i)]; }
    const std::vector<int>& alive(int p) const { return members[static_cast<std::size_t>(p)]; }
    const PartCost& cost(int p) const { return costs[static_cast<std::size_t>(p)]; }
};

/// Parts for the looks and an item for each element; verbatim ones are in no list of members. Several copies in the same
/// place become one item of a part that holds them all, so that places are unique.
SearchState starting_state(const Instancing& instancing, const PoseTolerance& tolerance, double diagonal);

/// Recomputes members and costs of these parts after items were added or died.
void refresh(SearchState& state, const std::vector<int>& parts);

/// A step's parameters in bits: short for 0, right angles, multiples of 15 degrees and scale 1.
double step_bits(const SearchState& state, int from, int to, const Similarity& step);

}  // namespace rinceau
