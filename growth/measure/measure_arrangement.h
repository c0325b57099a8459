#pragma once
// How like its exemplar an arrangement is, in figures (docs/growth.md says what each can be expected to be). Nothing here
// is taken from the growth itself but where elements stand and whom they call neighbours.

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "growth/arrangement/arrange_options.h"
#include "growth/arrangement/exemplar.h"
#include "growth/arrangement/grow_arrangement.h"

namespace rinceau {

/// Shares are in [0, 1]; ratios are the arrangement's figure over the exemplar's. "Inside" is all that lies deeper than 1.5
/// l within what the elements cover, where rings can be whole. A figure that cannot be told (too few elements) is the one of
/// a perfect arrangement.
struct ArrangementMeasures {
    std::size_t elements = 0;
    std::size_t inside = 0;    ///< elements there
    std::size_t overlaps = 0;  ///< pairs of outlines that share area
    std::size_t too_near = 0;  ///< pairs of centres nearer than 0.97 of the least distance of their symbols in the exemplar
    std::size_t over_boundary = 0;  ///< outlines that a boundary line cuts or that reach out of the region
    double least_distance = 1;      ///< the smallest ratio of such a distance to the exemplar's
    double pair_distance = 0;       ///< between the pair correlations
    double pair_spread = 0;         ///< the same between halves of the exemplar: what can be expected
    double degree_distance = 0;     ///< between the histograms of numbers of neighbours inside: share that must change
    double right_degrees = 1;       ///< share of the elements inside with as many neighbours as their reference
    double spacing_error = 0;       ///< rms of the lengths of edges inside against the reference's ring, over l
    double largest_spacing_error = 0;
    double ring_error = 0;       ///< rms of places of neighbours inside against the reference's ring, over l
    double defects = 0;          ///< neighbours inside that the reference has no place for within l/2, an element
    double density = 1;          ///< ratio
    std::vector<double> shares;  ///< per symbol, of all elements
    /// Symbols without a usable element: they cannot grow, and the shares wanted of the others are those without them.
    std::size_t lost_symbols = 0;
    double share_error = 0;        ///< largest relative one, of symbols with a share of at least 15 %
    double small_share_error = 0;  ///< of the other symbols that can grow
    double empty_circle = 1;       ///< ratio of the radii of the largest circles inside without a centre
    double repeats = 0;            ///< share of pairs within 2.6 l that are copies of the same element
    double chance = 0;             ///< the same if every usable element of the exemplar were drawn alike
    double verbatim = 0;           ///< share of neighbours that are neighbours in the exemplar: 1 = a copy of it
};

/// `edges` as arranged_edges() gives them. Elements of the exemplar stand in its order.
ArrangementMeasures measure_arrangement(const Exemplar& exemplar, const std::vector<ArrangedElement>& elements,
                                        std::span<const std::pair<int, int>> edges, const ArrangeSurroundings& around = {});

/// The same of a grown arrangement.
ArrangementMeasures measure_arrangement(const Exemplar& exemplar, const ElementArrangement& arrangement,
                                        const ArrangeSurroundings& around = {});

}  // namespace rinceau
