#pragma once
// How far the neighbours of elements are from where their references in the exemplar have theirs.

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "growth/arrangement/arrange_options.h"
#include "growth/arrangement/exemplar.h"

namespace rinceau {

/// Shares of elements with 0, 1, 2 .. neighbours.
using DegreeHistogram = std::vector<double>;

/// The share of elements that would have to get another number of neighbours to make one histogram of the other.
double degree_distance(const DegreeHistogram& a, const DegreeHistogram& b);

/// Of the elements that are usable, whose rings are whole.
DegreeHistogram degree_histogram(const Exemplar& exemplar);

struct RingFit {
    DegreeHistogram degrees;
    double right_degrees = 1;  ///< share of elements with as many neighbours as their reference
    double spacing_error = 0;  ///< rms of the differences of lengths, over l
    double largest_spacing_error = 0;
    double ring_error = 0;  ///< rms of the distances of places, over l
    double defects = 0;     ///< neighbours without a place, an element
};

/// Each neighbour of an element is compared with the nearest place of its reference's ring, turned by the element's angle;
/// beyond l/2 there is no place for it. Only elements that are `asked` count.
RingFit ring_fit(const Exemplar& exemplar, const std::vector<ArrangedElement>& elements,
                 std::span<const std::pair<int, int>> edges, const std::vector<bool>& asked);

}  // namespace rinceau
