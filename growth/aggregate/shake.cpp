#include "growth/aggregate/shake.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rinceau {
namespace {

constexpr double first_step = 0.2;  // of the radius
constexpr int failures_a_step = 5;  // then the step is halved
constexpr int max_failures = 20;
constexpr int max_moves = 100;
constexpr double wobble = radians(30.0);  // of the direction, either way
constexpr double turn_wobble = 0.2;       // radians, either way: shapes turn into each other's bays
const double golden_angle = pi * (3 - std::sqrt(5.0));

}  // namespace

ShakeRound::ShakeRound(const Packing& packing, int round)
    : direction_(golden_angle * round), order_(packing.placed().size()) {
    const Point along = polar(1, direction_);
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::ranges::stable_sort(order_, std::ranges::greater{}, [&](std::size_t i) { return dot(along, packing.pose(i).at); });
}

bool ShakeRound::slide_next(Packing& packing) {
    if (next_ == order_.size()) return false;
    const std::size_t index = order_[next_++];
    const int shape = packing.placed()[index].shape;
    const PackAngles& angles = packing.options().angles;
    Random& random = packing.random();
    PackPose pose = packing.pose(index);
    packing.lift(index);
    double step = first_step * packing.region(shape).radius * pose.scale;
    for (int moves = 0, failures = 0; moves < max_moves && failures < max_failures; ++moves) {
        PackPose moved = pose;
        moved.at += polar(step, direction_ + random.uniform(-wobble, wobble));
        if (may_turn(angles)) moved.turn = nearest_turn(angles, moved.turn + random.uniform(-turn_wobble, turn_wobble));
        if (packing.is_free(shape, moved))
            pose = moved;
        else if (++failures % failures_a_step == 0)
            step /= 2;
    }
    packing.put_down(index, pose);
    return true;
}

double ShakeRound::fraction() const {
    return order_.empty() ? 1 : static_cast<double>(next_) / static_cast<double>(order_.size());
}

}  // namespace rinceau
