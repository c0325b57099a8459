#include "analyzer/spiral_law.h"

#include <algorithm>
#include <cmath>

namespace rinceau {

double spiral_index(const SpiralLaw& law, int k) { return std::max(0.0, law.start + k * law.direction); }

double spiral_size(const SpiralLaw& law, double index) {
    if (law.size_change == 0) return law.size;
    return law.size + law.size_change * std::pow(index, law.size_power);
}

Similarity spiral_pose(const SpiralLaw& law, double index) {
    const double angle = law.angle * index;
    const double turned = law.bearing + (law.upright ? 0 : angle);
    const Point place = polar(law.reach * std::pow(index, law.power), angle + pi / 2);
    const Complex linear = polar(spiral_size(law, index), turned);
    return {linear, place - linear * law.seat, false};
}

}  // namespace rinceau
