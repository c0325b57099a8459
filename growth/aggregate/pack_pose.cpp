#include "growth/aggregate/pack_pose.h"

#include <algorithm>

namespace rinceau {

Similarity similarity_of(const PackPose& pose, const PackAngles& angles) {
    const Complex turned = polar(pose.scale, pose.turn);
    return {angles.flow ? turned * direction_at(*angles.flow, pose.at) : turned, pose.at};
}

double draw_turn(const PackAngles& angles, Random& random) {
    if (angles.only.empty()) return random.uniform(angles.low, angles.high);
    return angles.only[random.below(static_cast<std::uint32_t>(angles.only.size()))];
}

bool may_turn(const PackAngles& angles) { return angles.only.empty() && angles.high > angles.low; }

double nearest_turn(const PackAngles& angles, double turn) {
    if (angles.high - angles.low >= two_pi) return turn;
    return std::clamp(turn, angles.low, angles.high);
}

}  // namespace rinceau
