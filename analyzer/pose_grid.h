#pragma once
// Look-up of predicted poses among the items of one part (docs/analysis.md, 4.2), modulo the part's symmetry.

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "analyzer/pose_tolerance.h"
#include "analyzer/rule_model.h"

namespace rinceau {

struct PoseMatch {
    int item = 0;
    int gauge = 0;     ///< item.pose * symmetry[gauge] is the predicted pose
    double shift = 0;  ///< distance of the origins, scene lengths
};

/// A hash grid over the items' origins. Keeps references to the rules: use it while they live; items that are no longer
/// alive are passed over.
class PoseGrid {
  public:
    PoseGrid(const RuleSet& rules, int part, std::span<const int> items);

    /// The nearest living item whose pose is `predicted` within the tolerance; ties by index.
    std::optional<PoseMatch> find(const Similarity& predicted, double distance, const PoseTolerance& tolerance) const;

    int part() const { return part_; }
    /// A length of the order of the distance of neighbours.
    double cell() const { return cell_; }

  private:
    std::int64_t key(std::int64_t x, std::int64_t y) const { return x * 0x9E3779B1LL ^ (y * 0x85EBCA77LL << 16); }
    void consider(int item, const Similarity& predicted, double reach, double turn, std::optional<PoseMatch>& best) const;

    const RuleSet* rules_;
    int part_;
    double cell_ = 1;
    struct Range {
        int begin = 0, end = 0;
    };
    std::unordered_map<std::int64_t, Range> ranges_;
    std::vector<int> items_;  // sorted by cell
};

/// The symmetry element that turns `pose` into `predicted` within `turn`, or -1.
int matching_gauge(const Part& part, const Similarity& pose, const Similarity& predicted, double turn);

}  // namespace rinceau
