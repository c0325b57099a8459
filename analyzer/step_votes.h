#pragma once
// Clusters of steps: the transformation space of a pair of parts, sampled by neighbours (Stava et al. 2010, section 4.3;
// docs/analysis.md, 4.1).

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/index_map.h"
#include "geometry/similarity.h"

namespace rinceau {

struct StepVote {
    Similarity step;
    int source = 0;          ///< item
    int target = 0;          ///< item
    double turn_change = 0;  ///< linear rules: how alpha and beta differ in the step that follows
    double spin_change = 0;
};

/// Who cast a vote: items.
struct Voters {
    int source = 0;
    int target = 0;
};

struct StepCluster {
    Similarity step;  ///< means of the votes
    double turn_change = 0;
    double spin_change = 0;
    std::vector<Voters> votes;  ///< in the order in which they were cast
};

struct VoteCell {
    double place = 0.03;         ///< cell in units of the source's size at short distance
    double spin = 0.03;          ///< cell of the unit linear part
    double per_distance = 0.05;  ///< growth of the place cell with distance
};

/// A place in a space of votes, in cells.
using VoteCoordinates = std::array<double, 4>;

/// A constant step: two coordinates of place, two of direction and size (no circular axes).
VoteCoordinates step_coordinates(const Similarity& step, const VoteCell& cell);

/// A step that changes evenly: (d, s, change of alpha, change of beta).
VoteCoordinates linear_coordinates(const StepVote& vote, const VoteCell& cell);

class StepVotes {
  public:
    /// Joins the nearest cluster whose first vote lies within one cell on every axis, or founds one.
    void add(const StepVote& vote, const VoteCoordinates& at);
    /// Clusters with at least `least` votes, most votes first (ties: in order of the first vote), at most `most`.
    std::vector<StepCluster> clusters(std::size_t least, std::size_t most) const;
    std::size_t size() const { return votes_.size(); }

  private:
    struct Bin {
        VoteCoordinates seed;
        bool mirrored = false;
        int next_in_cell = IndexMap::none;  // the bin that was founded before in the same cell
        int votes = 0;
        // Sums over the votes.
        Complex direction;
        Point translation;
        double log_size = 0, turn_change = 0, spin_change = 0;
    };
    struct Cast {
        int bin = 0;
        Voters voters;
    };
    /// The bin with the nearest seed within one cell, or none.
    int nearest_bin(const VoteCoordinates& at, bool mirrored) const;
    int new_bin(const VoteCoordinates& at, bool mirrored);
    StepCluster cluster_of(const Bin& bin) const;

    std::vector<Bin> bins_;
    std::vector<Cast> votes_;
    IndexMap last_in_cell_;  // the bin that was founded last in a cell
};

}  // namespace rinceau
