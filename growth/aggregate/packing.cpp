#include "growth/aggregate/packing.h"

#include <algorithm>
#include <cmath>

#include "growth/aggregate/pack_check.h"

namespace rinceau {
namespace {

/// Cells across the largest inner disc of the least shape; half as many cost some hundredths of what is filled.
constexpr double cells_a_disc = 3;
constexpr std::size_t max_field_cells = 16'000'000;
/// Gaps that hold less than this part of the least shape's largest disc are left alone.
constexpr double least_gap_share = 0.25;
/// Below this density nothing stands.
constexpr double least_density = 1.0 / 256;

double least_disc(const std::vector<ExclusiveRegion>& regions) {
    double radius = regions.front().discs.front().radius;
    for (const ExclusiveRegion& region : regions) radius = std::min(radius, region.discs.front().radius);
    return radius;
}

double perimeter(const ExclusiveRegion& region) {
    double length = 0;
    const auto& ring = region.rings.front();
    for (std::size_t i = 0; i < ring.size(); ++i) length += abs(ring[(i + 1) % ring.size()] - ring[i]);
    return length;
}

double folded(double x, double low, double size) {
    const double turns = std::floor((x - low) / size);
    // Rounding may put x a digit below its own turn.
    return std::clamp(x - turns * size, low, low + size);
}

}  // namespace

Packing::Packing(std::vector<ExclusiveRegion> regions, PackDomain domain, AggregateOptions options, const std::string& label)
    : regions_(std::move(regions)),
      domain_(std::move(domain)),
      options_(std::move(options)),
      turn_(checked_shares(regions_, domain_, options_, label), options_.share_tolerance),
      grid_(regions_, domain_, options_.min_scale, options_.max_scale),
      random_(options_.seed) {
    for (const ExclusiveRegion& region : regions_) {
        mean_area_ += region.area / static_cast<double>(regions_.size());
        mean_perimeter_ += perimeter(region) / static_cast<double>(regions_.size());
    }
}

double Packing::density(Point at) const {
    return options_.density ? std::clamp(density_at(*options_.density, at), 0.0, 1.0) : 1;
}

double Packing::largest_scale(Point at) const { return std::lerp(options_.min_scale, options_.max_scale, density(at)); }

/// A shape of area A and perimeter P that keeps half of g to itself takes A + P g / 2 + pi g^2 / 4; this is to be A /
/// density.
double Packing::clearance_for(double density) const {
    if (density >= 1) return 0;
    const double scale = 0.5 * (options_.min_scale + std::lerp(options_.min_scale, options_.max_scale, density));
    const double more = mean_area_ * scale * scale * (1 / std::max(density, least_density) - 1);
    const double half = mean_perimeter_ * scale / 2;
    return 2 / pi * (std::sqrt(half * half + pi * more) - half);
}

double Packing::clearance(Point at) const { return options_.density ? clearance_for(density(at)) : 0; }

Point Packing::draw_point() {
    const Box box = domain_.region ? bounds(*domain_.region) : domain_.box;
    const double x = random_.uniform(box.low.x, box.high.x);
    return {x, random_.uniform(box.low.y, box.high.y)};
}

PackPose Packing::draw_pose(Point at) {
    const double scale = random_.uniform(options_.min_scale, largest_scale(at));
    return {at, scale, draw_turn(options_.angles, random_)};
}

PackPose Packing::folded(PackPose pose) const {
    if (!domain_.tiled) return pose;
    pose.at = {rinceau::folded(pose.at.x, domain_.box.low.x, width(domain_.box)),
               rinceau::folded(pose.at.y, domain_.box.low.y, height(domain_.box))};
    return pose;
}

void Packing::cancel() {
    ++counts_.attempted;
    ++counts_.cancelled;
    ++cancelled_in_row_;
    turn_.cancelled();
}

bool Packing::is_free(int shape, const PackPose& pose) {
    ++counts_.tested;
    const PackPose home = folded(pose);
    return density(home.at) >= (options_.density ? least_density : 0) &&
           grid_.is_free(shape, similarity_of(home, options_.angles));
}

bool Packing::try_place(int shape, const PackPose& pose) {
    if (!is_free(shape, pose)) {
        cancel();
        return false;
    }
    const PackPose home = folded(pose);
    const Similarity similarity = similarity_of(home, options_.angles);
    grid_.place({shape, similarity});
    poses_.push_back(home);
    ++counts_.attempted;
    cancelled_in_row_ = 0;
    turn_.placed(shape);
    if (field_) sampler_->update(*field_, field_->add(outline_at(shape, similarity)));
    return true;
}

void Packing::put_down(std::size_t index, const PackPose& pose) {
    poses_[index] = folded(pose);
    grid_.put_back(index, similarity_of(poses_[index], options_.angles));
}

Region Packing::outline_at(int shape, const Similarity& pose) const {
    Region outline = region(shape).rings;
    for (auto& ring : outline)
        for (Point& p : ring) p = apply(pose, p);
    return outline;
}

std::vector<float> Packing::clearances() const {
    std::vector<float> result;
    if (!options_.density) return result;
    for (int row = 0; row < field_->rows(); ++row)
        for (int column = 0; column < field_->columns(); ++column)
            result.push_back(static_cast<float>(clearance(field_->middle(column, row))));
    return result;
}

void Packing::make_field() {
    const double disc = least_disc(regions_) * options_.min_scale;
    if (!field_) field_.emplace(domain_, disc / cells_a_disc, max_field_cells);
    field_->clear();
    std::vector<Region> outlines;
    for (const PlacedRegion& region : placed()) outlines.push_back(outline_at(region.shape, region.pose));
    field_->add_all(outlines);
    if (sampler_)
        sampler_->update(*field_);
    else
        sampler_.emplace(*field_, least_gap_share * disc, clearances());
}

}  // namespace rinceau
