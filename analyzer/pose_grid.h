#pragma once
// Look-up of predicted poses among the items of one part (docs/analysis.md, 4.2), modulo the part's symmetry.

#include <optional>
#include <span>
#include <vector>

#include "analyzer/pose_tolerance.h"
#include "analyzer/rule_model.h"

namespace rinceau {

struct PoseMatch {
    int item = 0;
    int gauge = 0;     ///< item.pose * symmetry[gauge] is the predicted pose
    double shift = 0;  ///< distance of the origins, scene lengths
};

/// A grid of cells over the items' origins. Keeps references to the rules: use it while they live; items that are no longer
/// alive are passed over. The origins of living items must not change meanwhile.
class PoseGrid {
  public:
    PoseGrid(const RuleSet& rules, int part, std::span<const int> items);

    /// The nearest living item whose pose is `predicted` within the tolerance; ties by index.
    std::optional<PoseMatch> find(const Similarity& predicted, double distance, const PoseTolerance& tolerance) const;

    int part() const { return part_; }

  private:
    struct Place {
        Point origin;
        int item = 0;
    };

    /// Column of x or row of y; what lies beyond the grid counts to the cells at its border.
    static int cell_index(double offset, double per_cell, int count);
    int column(double x) const { return cell_index(x - low_.x, per_cell_, columns_); }
    int row(double y) const { return cell_index(y - low_.y, per_cell_, rows_); }
    void consider(const Place& place, const Similarity& predicted, double reach, double turn,
                  std::optional<PoseMatch>& best) const;

    const RuleSet* rules_;
    int part_;
    Point low_;
    double per_cell_ = 1;  // cells per scene length
    int columns_ = 1, rows_ = 1;
    std::vector<int> begin_;     // of each cell in places_, row by row; one more at the end
    std::vector<Place> places_;  // by cell
};

/// The symmetry element that turns `pose` into `predicted` within `turn`, or -1.
int matching_gauge(const Part& part, const Similarity& pose, const Similarity& predicted, double turn);

}  // namespace rinceau
