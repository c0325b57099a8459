#pragma once
// Which element of the exemplar fits where a seed stands (Ijiri et al. 2008, sections 5.2 and 5.3).

#include <limits>
#include <vector>

#include "growth/arrangement/growth_ground.h"

namespace rinceau {

/// A neighbour of the place to be filled, as eq. 2 compares it.
struct RingNeighbor {
    int node = -1;
    Point offset;               ///< from the place
    int symbol = -1;            ///< -1 = any
    int sub_id = -1;            ///< of elements
    std::array<int, 2> step{};  ///< from the place, in columns and rows of a lattice
};

/// What surrounds the place to be filled.
struct TargetRing {
    std::vector<RingNeighbor> inner;  ///< counter-clockwise, from the far side of the largest gap
    std::vector<RingNeighbor> outer;  ///< the neighbours' neighbours; only if two rings are compared
};

/// The node's neighbours.
TargetRing target_ring(const ElementArrangement& arrangement, const GrowthGround& ground, int node);
/// The same of nodes that are no neighbours yet.
TargetRing ring_of_nodes(const ElementArrangement& arrangement, const GrowthGround& ground, int node,
                         const std::vector<int>& others);

/// A matching of rings (the f of eq. 3).
struct ReferenceMatch {
    int reference = -1;  ///< -1 = none found
    double angle = 0;    ///< of the reference's ring
    double cost = std::numeric_limits<double>::infinity();
    std::vector<int> places;  ///< of the reference's ring, by neighbour; -1 = unmatched
};

/// Compares rings; keeps its room between calls.
class RingMatcher {
  public:
    RingMatcher(const GrowthGround& ground, const MatchWeights& weights) : ground_(ground), weights_(weights) {}

    /// The best matching of the ring with the reference's that costs less than `limit`, on top of `base` (eq. 2, and eq. 4
    /// in mode rotate); `angle` is that of the ring in the other modes, and here the one to be preferred. Nothing found:
    /// reference -1.
    ReferenceMatch match(const TargetRing& ring, int reference, double angle, double base, double limit);
    /// The same by nearest places in mode rotate for a ring whose angle is nearly known.
    ReferenceMatch match_near(const TargetRing& ring, int reference, double angle, double base, double limit);
    /// The matching by nearest places with a ring that is turned by `angle`, whatever it costs.
    ReferenceMatch match_turned(const TargetRing& ring, int reference, double angle);

  private:
    void turn_places(const ReferenceRing& ring, Complex turn);
    double pair_cost(const RingNeighbor& neighbor, const ReferenceRing& ring, std::size_t place) const;
    double unmatched_cost() const;
    double match_nearest(const TargetRing& target, const ReferenceRing& ring, double base, double limit);
    double match_sites(const TargetRing& target, int reference, double base, double limit);
    double match_in_order(const TargetRing& target, const ReferenceRing& ring, std::size_t first, double base, double limit);
    double outer_cost(const TargetRing& target, const ReferenceRing& ring, Complex turn, double cost, double limit) const;
    Complex fitted_turn(const TargetRing& target, const ReferenceRing& ring, Complex otherwise) const;
    void keep(ReferenceMatch& best, int reference, Complex turn, double cost);
    void try_turn(const TargetRing& target, int reference, Complex turn, double base, double limit, ReferenceMatch& best);
    void try_shifts(const TargetRing& target, int reference, Complex turn, double base, double limit, ReferenceMatch& best);

    const GrowthGround& ground_;
    MatchWeights weights_;
    std::vector<Point> turned_;  // the reference's places
    std::vector<char> taken_;    // by place
    std::vector<int> places_;    // by neighbour
};

}  // namespace rinceau
