#pragma once
// An aggregate in the making: what is placed, what is free, whose turn it is.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geometry/random.h"
#include "growth/aggregate/aggregate_options.h"
#include "growth/aggregate/distance_field.h"
#include "growth/aggregate/exclusive_region.h"
#include "growth/aggregate/gap_sampler.h"
#include "growth/aggregate/pack_pose.h"
#include "growth/aggregate/region_grid.h"
#include "growth/aggregate/shape_turn.h"

namespace rinceau {

/// Nothing is placed or moved but by the exact test, so that at any time there is no overlap. The field, once it is there,
/// knows all that is placed; after a move it must be made anew.
class Packing {
  public:
    /// Throws InputError as AggregateFill.
    Packing(std::vector<ExclusiveRegion> regions, PackDomain domain, AggregateOptions options, const std::string& label);

    const AggregateOptions& options() const { return options_; }
    const ExclusiveRegion& region(int shape) const { return regions_[static_cast<std::size_t>(shape)]; }
    const std::vector<ExclusiveRegion>& regions() const { return regions_; }
    const PackDomain& domain() const { return domain_; }
    const std::vector<PlacedRegion>& placed() const { return grid_.placed(); }
    const AggregateCounts& counts() const { return counts_; }
    std::size_t cancelled_in_row() const { return cancelled_in_row_; }
    Random& random() { return random_; }

    /// The shape whose turn it is, at a scale and an angle that are drawn for this place.
    int next_shape() const { return turn_.next(); }
    PackPose draw_pose(Point at);
    /// Uniform in the box of what is filled.
    Point draw_point();
    /// What is to stand there, 0 to 1.
    double density(Point at) const;
    /// How far shapes keep apart there for the sake of the density picture.
    double clearance(Point at) const;
    /// The largest scale there.
    double largest_scale(Point at) const;

    /// A placement that is given up before the exact test.
    void cancel();
    /// Places the shape if the place is free; true if it was.
    bool try_place(int shape, const PackPose& pose);
    bool is_free(int shape, const PackPose& pose);
    /// Where that one stands.
    const PackPose& pose(std::size_t index) const { return poses_[index]; }
    /// Out of the way; then down again where it was or where is_free() has said so.
    void lift(std::size_t index) { grid_.take_out(index); }
    void put_down(std::size_t index, const PackPose& pose);
    /// Cancellations count anew.
    void begin_stage() { cancelled_in_row_ = 0; }

    /// Makes the field of all that is placed.
    void make_field();
    bool has_field() const { return field_.has_value(); }
    const DistanceField& field() const { return *field_; }
    std::optional<Point> draw_gap() { return sampler_->draw(*field_, random_); }

  private:
    Region outline_at(int shape, const Similarity& pose) const;
    PackPose folded(PackPose pose) const;
    double clearance_for(double density) const;
    std::vector<float> clearances() const;

    std::vector<ExclusiveRegion> regions_;
    PackDomain domain_;
    AggregateOptions options_;
    double mean_area_ = 0, mean_perimeter_ = 0;  ///< of the shapes at scale 1
    ShapeTurn turn_;
    RegionGrid grid_;
    Random random_;
    AggregateCounts counts_;
    std::vector<PackPose> poses_;
    std::size_t cancelled_in_row_ = 0;
    std::optional<DistanceField> field_;
    std::optional<GapSampler> sampler_;
};

}  // namespace rinceau
