#include "analyzer/concentric_rings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace rinceau {

namespace {

constexpr double deviations = 3;  // standard errors by which equal things may differ

double members(const Arrangement& ring) { return static_cast<double>(ring.bodies.size()); }
double radius_of(const Arrangement& ring) { return abs(ring.slots.front().translation); }
/// Standard error of the centre and of the radius.
double error_of(const Arrangement& ring) { return ring.spread / std::sqrt(members(ring)); }
double phase_error(const Arrangement& ring) { return error_of(ring) / radius_of(ring); }

/// The slots of a ring with another radius and another pose of its first member's frame.
void reshape(Arrangement& ring, double radius, Complex linear) {
    for (std::size_t k = 0; k < ring.slots.size(); ++k) {
        const Complex turned = polar(1, two_pi * static_cast<double>(k) / members(ring));
        ring.slots[k].linear = linear * turned;
        ring.slots[k].translation = radius * turned;
    }
}

using Rings = std::vector<Arrangement*>;

/// Rings about the same centre, the most exact one first.
std::vector<Rings> by_centre(std::vector<Arrangement>& arrangements) {
    Rings open;
    for (Arrangement& each : arrangements) {
        if (each.is_ring) open.push_back(&each);
    }
    std::ranges::stable_sort(open, {}, [](const Arrangement* ring) { return phase_error(*ring); });
    std::vector<Rings> families;
    for (Arrangement* ring : open) {
        const auto family = std::ranges::find_if(families, [&](const Rings& rings) {
            const double off = abs(rings.front()->whole.translation - ring->whole.translation);
            return off <= deviations * std::hypot(error_of(*rings.front()), error_of(*ring));
        });
        if (family == families.end()) {
            families.push_back({ring});
        } else {
            family->push_back(ring);
        }
    }
    return families;
}

void join_centres(const Rings& rings) {
    Point sum{};
    double weights = 0;
    for (const Arrangement* ring : rings) {
        const double weight = members(*ring) / std::max(1e-12, ring->spread * ring->spread);
        sum += weight * ring->whole.translation;
        weights += weight;
    }
    for (Arrangement* ring : rings) ring->whole.translation = sum / weights;
}

/// Turns the ring so that its phase is a multiple of `unit` against `reference`, if it nearly is.
void turn_to(Arrangement& ring, Complex reference, double unit, double error) {
    ring.whole.linear = ring.whole.linear * polar(1, -off_natural(arg(ring.whole.linear / reference), unit, error));
}

void join_phases(const Rings& rings) {
    // The first against the axes, the others against the first.
    Arrangement& first = *rings.front();
    turn_to(first, {1, 0}, pi / std::lcm(2, first.form.fold), phase_error(first));
    for (std::size_t r = 1; r < rings.size(); ++r) {
        const double unit = pi / std::lcm(first.form.fold, rings[r]->form.fold);
        turn_to(*rings[r], first.whole.linear, unit, std::hypot(phase_error(first), phase_error(*rings[r])));
    }
}

/// Directions and sizes of bodies of one kind, if they agree.
void join_members(const Rings& rings, const BodyForm& form) {
    constexpr double as_good_as_equal = 0.1;  // radians and log ratio
    const Complex first = rings.front()->slots.front().linear;
    double turn = 0, log_ratio = 0, weights = 0;
    for (const Arrangement* ring : rings) {
        const Complex ratio = ring->slots.front().linear / first;
        const double off = form.fold > 0 ? std::remainder(arg(ratio), two_pi / form.fold) : 0;
        if (std::abs(off) > as_good_as_equal || std::abs(std::log(abs(ratio))) > as_good_as_equal) return;
        turn += members(*ring) * off;
        log_ratio += members(*ring) * std::log(abs(ratio));
        weights += members(*ring);
    }
    const Complex mean = first * polar(std::exp(log_ratio / weights), turn / weights);
    for (Arrangement* ring : rings) reshape(*ring, radius_of(*ring), mean);
}

/// Radii at even distances, if they nearly are.
void space_radii(Rings rings) {
    constexpr std::size_t least_rings = 3;
    if (rings.size() < least_rings) return;
    std::ranges::stable_sort(rings, {}, [](const Arrangement* ring) { return radius_of(*ring); });
    const double n = static_cast<double>(rings.size());
    double mean = 0, slope = 0;
    for (std::size_t k = 0; k < rings.size(); ++k) {
        const double from_middle = static_cast<double>(k) - (n - 1) / 2;
        mean += radius_of(*rings[k]) / n;
        slope += from_middle * radius_of(*rings[k]) / (n * (n * n - 1) / 12);
    }
    const auto even = [&](std::size_t k) { return mean + slope * (static_cast<double>(k) - (n - 1) / 2); };
    for (std::size_t k = 0; k < rings.size(); ++k) {
        if (std::abs(radius_of(*rings[k]) - even(k)) > deviations * error_of(*rings[k])) return;
    }
    for (std::size_t k = 0; k < rings.size(); ++k) reshape(*rings[k], even(k), rings[k]->slots.front().linear);
}

}  // namespace

std::vector<Arrangement> aligned_rings(std::vector<Arrangement> arrangements, std::span<const BodyForm> forms) {
    for (const Rings& rings : by_centre(arrangements)) {
        join_centres(rings);
        join_phases(rings);
        std::map<std::pair<int, int>, Rings> alike;  // by kind of body and number
        for (Arrangement* ring : rings) alike[{ring->kind, ring->form.fold}].push_back(ring);
        for (auto& [key, same] : alike) {
            join_members(same, forms[static_cast<std::size_t>(key.first)]);
            space_radii(same);
        }
    }
    return arrangements;
}

}  // namespace rinceau
