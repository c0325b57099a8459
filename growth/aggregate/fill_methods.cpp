// Where the paper draws angle and scale once for each place, so does this; settling and growing are not in the paper.

#include "growth/aggregate/fill_methods.h"

#include <algorithm>
#include <cmath>

#include "growth/aggregate/settle.h"

namespace rinceau {
namespace {

constexpr std::size_t points_a_round = 100;  // P
constexpr std::size_t max_circle_cells = 500'000;

double greatest_circle(const Packing& packing) {
    double radius = 0;
    for (const ExclusiveRegion& region : packing.regions()) radius = std::max(radius, region.radius);
    return radius * packing.options().max_scale;
}

constexpr std::uint32_t discs_to_start_with = 5;
constexpr double least_start = 0.6;  // of the disc's radius, that the point must be away from everything
constexpr double shrink = 0.9;
constexpr int max_shrinks = 6;
constexpr double most_growth = 1.6;
constexpr int growth_halvings = 5;

/// The shape with one of its largest discs on the point, if that is not far too deep in something, settled from there.
std::optional<PackPose> settled_about(Packing& packing, int shape, const PackPose& drawn, double gap) {
    const ExclusiveRegion& region = packing.region(shape);
    const auto count = std::min(static_cast<std::uint32_t>(region.discs.size()), discs_to_start_with);
    const InnerDisc& disc = region.discs[packing.random().below(count)];
    if (gap < least_start * disc.radius * drawn.scale) return std::nullopt;
    PackPose start = drawn;
    start.at -= similarity_of(drawn, packing.options().angles).linear * disc.center;
    return settled(packing.field(), region, start, packing.options().angles, packing.clearance(start.at));
}

/// Halves the way between a scale that fits and the largest one that might.
PackPose grown_pose(Packing& packing, int shape, PackPose fitting, bool settling) {
    double low = fitting.scale, high = std::min(packing.largest_scale(fitting.at), most_growth * fitting.scale);
    for (int i = 0; i < growth_halvings && high > low; ++i) {
        PackPose larger = fitting;
        larger.scale = i == 0 ? high : 0.5 * (low + high);
        std::optional<PackPose> pose = larger;
        if (settling)
            pose = settled(packing.field(), packing.region(shape), larger, packing.options().angles,
                           packing.clearance(larger.at));
        if (pose && packing.is_free(shape, *pose)) {
            fitting = *pose;
            low = fitting.scale;
        } else {
            high = larger.scale;
        }
    }
    return fitting;
}

/// At the scale that was drawn or the largest below it that fits; then as much larger as there is room.
std::optional<PackPose> fitted_about(Packing& packing, int shape, PackPose drawn, double gap) {
    const double least = packing.options().min_scale;
    for (int shrinks = 0; shrinks <= max_shrinks; ++shrinks) {
        const std::optional<PackPose> pose = settled_about(packing, shape, drawn, gap);
        if (pose && packing.is_free(shape, *pose)) return grown_pose(packing, shape, *pose, true);
        if (drawn.scale <= least) break;
        drawn.scale = std::max(shrink * drawn.scale, least);
    }
    return std::nullopt;
}

}  // namespace

void try_dart(Packing& packing, bool growing) {
    const PackPose pose = packing.draw_pose(packing.draw_point());
    // The density picture says how likely a dart is to stay.
    if (packing.options().density && packing.random().uniform() >= packing.density(pose.at)) return packing.cancel();
    const int shape = packing.next_shape();
    packing.try_place(shape, growing && packing.is_free(shape, pose) ? grown_pose(packing, shape, pose, false) : pose);
}

SparseStart::SparseStart(const Packing& packing)
    : circles_(packing.domain().region ? bounds(*packing.domain().region) : packing.domain().box,
               2 * greatest_circle(packing), max_circle_cells),
      reach_(greatest_circle(packing)) {}

bool SparseStart::is_apart(const Packing& packing, Point at, double radius) const {
    const Box& box = packing.domain().box;
    const int ring = packing.domain().tiled ? 1 : 0;
    for (int down = -ring; down <= ring; ++down)
        for (int right = -ring; right <= ring; ++right) {
            const Point p = at + Point{right * width(box), down * height(box)};
            const auto apart = [&](CellEntry entry) {
                const PlacedRegion& other = packing.placed()[entry.owner];
                const double reach = radius + packing.region(other.shape).radius * scale_of(other.pose);
                return norm(p - other.pose.translation) > reach * reach;
            };
            const Box around = grown(Box{p, p}, radius + reach_);
            if (!circles_.walk(around, [&](int column, int row) { return circles_.visit(column, row, apart); }))
                return false;
        }
    return true;
}

void SparseStart::try_circle(Packing& packing) {
    const PackPose pose = packing.draw_pose(packing.draw_point());
    const int shape = packing.next_shape();
    const double radius = packing.region(shape).radius * pose.scale + packing.clearance(pose.at);
    if (!is_apart(packing, pose.at, radius)) return packing.cancel();
    if (!packing.try_place(shape, pose)) return;
    const Point at = packing.placed().back().pose.translation;
    circles_.add(circles_.column_at(at.x), circles_.row_at(at.y),
                 {static_cast<std::uint32_t>(packing.placed().size() - 1), 0});
}

bool GapRound::try_point(Packing& packing, bool growing) {
    if (points_.empty())
        for (std::size_t i = 0; i < points_a_round; ++i)
            if (const std::optional<Point> point = packing.draw_gap()) points_.push_back(*point);
    if (points_.empty()) return false;
    const PackPose pose = packing.draw_pose(points_.back());
    points_.pop_back();
    const int shape = packing.next_shape();
    packing.try_place(shape, growing && packing.is_free(shape, pose) ? grown_pose(packing, shape, pose, false) : pose);
    return true;
}

bool try_settled(Packing& packing, bool growing) {
    const std::optional<Point> point = packing.draw_gap();
    if (!point) return false;
    const int shape = packing.next_shape();
    const double gap = packing.field().at(*point) - packing.clearance(*point);
    const PackPose drawn = packing.draw_pose(*point);
    const auto pose = growing ? fitted_about(packing, shape, drawn, gap) : settled_about(packing, shape, drawn, gap);
    if (pose)
        packing.try_place(shape, *pose);
    else
        packing.cancel();
    return true;
}

}  // namespace rinceau
