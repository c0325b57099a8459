#pragma once
// Numbers that crowd about a few places, the places being as evenly spaced as the numbers allow: rows and columns of an
// irregular drawing, one axis at a time.

#include <span>
#include <vector>

namespace rinceau {

struct EvenPlaces {
    std::vector<int> place_of;    ///< of each value, counted upwards
    std::vector<double> places;   ///< rising
    std::vector<int> gap_classes; ///< between successive places; equal numbers are equal gaps
    int classes = 0;
    double spread = 0;            ///< root mean square of value - place
    double least_gap = 0;         ///< between places; 0 if there is but one
    double bits = 0;              ///< of the values: their deviations, the gaps and which is which
    double chance_bits = 0;       ///< log2 of the probability of such values by chance
};

/// Values that are nearer than `split` to the next one share a place. `precision`: what a deviation is measured in for bits.
EvenPlaces even_places(std::span<const double> values, double split, double precision);

}  // namespace rinceau
