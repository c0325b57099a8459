// Not in the paper. Every disc that is too near to something is pushed up the field by as much as it lacks; the shape
// follows as a rigid body. Discs lie inside the region, so what is refused here would be refused by the exact test, too.

#include "growth/aggregate/settle.h"

#include <algorithm>
#include <array>

namespace rinceau {
namespace {

constexpr int max_steps = 12;
constexpr int patient_steps = 2;         // before the worst lack must fall
constexpr double falling = 0.9;          // by so much in every step
constexpr double target_cells = 0.3;     // discs are pushed a little farther than they must
constexpr double tolerance_cells = 0.7;  // by which the field may be wrong
constexpr double turn_gain = 0.7;
constexpr double turn_inertia = 0.05;  // of the squared radius, for discs near the middle

/// What all discs together ask for.
struct Push {
    double worst = 0;  ///< the largest lack
    Point move;
    double turn = 0;
};

Push push_at(const DistanceField& field, const ExclusiveRegion& region, const Similarity& pose, double scale,
             double clearance) {
    Push push;
    Point moves;
    double torque = 0, inertia = 0;
    int pushed = 0;
    for (const InnerDisc& disc : region.discs) {
        const Point arm = pose.linear * disc.center;
        const Point at = pose.translation + arm;
        const double lack = disc.radius * scale + clearance + target_cells * field.step() - field.at(at);
        if (lack <= 0) continue;
        const Point force = lack * field.uphill(at);
        moves += force;
        torque += cross(arm, force);
        inertia += norm(arm);
        push.worst = std::max(push.worst, lack);
        ++pushed;
    }
    if (pushed == 0) return push;
    const double radius = region.radius * scale;
    push.move = moves / pushed;
    push.turn = turn_gain * torque / (inertia + turn_inertia * radius * radius * pushed);
    return push;
}

}  // namespace

std::optional<PackPose> settled(const DistanceField& field, const ExclusiveRegion& region, const PackPose& start,
                                const PackAngles& angles, double clearance) {
    PackPose pose = start;
    Push push = push_at(field, region, similarity_of(pose, angles), pose.scale, clearance);
    for (int step = 0; step < max_steps && push.worst > 0; ++step) {
        pose.at += push.move;
        if (may_turn(angles)) pose.turn = nearest_turn(angles, pose.turn + push.turn);
        const double worst = push.worst;
        push = push_at(field, region, similarity_of(pose, angles), pose.scale, clearance);
        if (step >= patient_steps && push.worst > falling * worst) break;
    }
    if (push.worst > (tolerance_cells + target_cells) * field.step()) return std::nullopt;
    return pose;
}

}  // namespace rinceau
