#pragma once
// Places about a pivot that are powers of an index: seeds of a flower head, points on an Archimedean spiral
// (docs/analysis.md, 4.6).

#include "geometry/similarity.h"

namespace rinceau {

/// Member k of a spiral has the index start + k * direction. Lengths and sizes in units of the pivot's frame, whose heading
/// (+y) is the direction of index 0.
struct SpiralLaw {
    double angle = 0;       ///< radians from one index to the next
    double reach = 1;       ///< distance of index 1 from the pivot
    double power = 0.5;     ///< distance = reach * index^power; > 0
    double start = 1;       ///< index of the first member
    int direction = 1;      ///< 1: outward, -1: inward
    double bearing = 0;     ///< a member's turn against its own radius; upright: against the pivot's frame
    Point seat;             ///< of a member's frame: what stands in the member's place instead of its origin
    bool upright = false;   ///< members do not turn with their radius
    double size = 1;        ///< size = size + size_change * index^size_power
    double size_change = 0;
    double size_power = 0.5;
};

double spiral_index(const SpiralLaw& law, int k);
double spiral_size(const SpiralLaw& law, double index);
/// Of the member with this index (>= 0), in the pivot's frame.
Similarity spiral_pose(const SpiralLaw& law, double index);

}  // namespace rinceau
