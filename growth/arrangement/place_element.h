#pragma once
// A seed becomes an element, and the unfilled places of its ring new seeds (Ijiri et al. 2008, section 5.4).

#include <vector>

#include "growth/arrangement/choose_reference.h"

namespace rinceau {

/// The symbol that a seed for an element of the exemplar has: its own, or none if no usable element has that.
int seed_symbol(const GrowthGround& ground, int symbol);

/// A seed gets its reference; its links stay as they are.
void become_element(ElementArrangement& arrangement, const GrowthGround& ground, int seed, int reference, double angle);

/// The element's link to `other` fills the place of its ring.
void fill_place(ElementArrangement& arrangement, const GrowthGround& ground, int element, int other, int place);

/// Where the matched elements want the reference to be; the seed's own place if that is far off or a line stands between.
Point fitted_position(const ElementArrangement& arrangement, const GrowthGround& ground, int seed, const TargetRing& ring,
                      const ReferenceMatch& match);

/// Puts the matched reference in the seed's place. `ring` is what the match was found for. Returns the new seeds; they are
/// in no queue yet.
std::vector<int> place_element(ElementArrangement& arrangement, const GrowthGround& ground, int seed, const TargetRing& ring,
                               const ReferenceMatch& match, Point at);

/// What is missing around an element: its unfilled places become links or new seeds, its ring is closed. Returns the new
/// seeds.
std::vector<int> complete_ring(ElementArrangement& arrangement, const GrowthGround& ground, int element);

/// An edge between elements fills at both ends the free place that is nearest, if one is within half an edge.
void claim_places(ElementArrangement& arrangement, const GrowthGround& ground, int a, int b);

/// Key of a lattice site in ElementArrangement::sites.
std::uint64_t site_key(std::array<int, 2> site);

}  // namespace rinceau
