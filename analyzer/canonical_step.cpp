#include "analyzer/canonical_step.h"

#include <cmath>

namespace rinceau {

namespace {

// Odd directions: the borders of the fundamental domains stay away from the angles that people draw.
const Complex place_direction = polar(1, 0.37);
const Complex spin_direction = polar(1, 0.53);
constexpr double near_tie = 1e-3;  // of the length: places on a mirror axis tie and are settled by the spin

double spin_rank(const Similarity& step) {
    const double unmirrored_first = step.mirrored ? -10 : 0;
    return unmirrored_first + dot(spin_direction, step.linear) / abs(step.linear);
}

/// The best step * t, t in the symmetry of `to`.
Similarity best_spin(const Part& to, const Similarity& step) {
    Similarity best = step;
    double best_rank = -100;
    for (const Similarity& t : to.symmetry.elements) {
        const Similarity candidate = step * t;
        const double rank = spin_rank(candidate);
        if (rank > best_rank) {
            best_rank = rank;
            best = candidate;
        }
    }
    return best;
}

}  // namespace

Similarity step_between(const Similarity& from, const Similarity& to) { return inverse(from) * to; }

Similarity canonical_step(const Part& from, const Part& to, const Similarity& step, double still) {
    const bool spinless = to.symmetry.continuous || from.symmetry.continuous;
    const auto settled = [&](const Similarity& turned) {
        if (!spinless) return best_spin(to, turned);
        return Similarity{{abs(turned.linear), 0}, turned.translation, false};
    };
    const double length = abs(step.translation);
    const bool in_place = length <= still;
    double best_reach = -2;
    for (const Similarity& s : from.symmetry.elements) {
        best_reach = std::max(best_reach, dot(place_direction, apply(s, step.translation)) / std::max(length, still));
    }
    Similarity best;
    double best_rank = -100;
    for (const Similarity& s : from.symmetry.elements) {
        const Similarity turned = s * step;
        if (!in_place && dot(place_direction, turned.translation) / length < best_reach - near_tie) continue;
        const Similarity candidate = settled(turned);
        const double rank = spin_rank(candidate);
        if (rank > best_rank) {
            best_rank = rank;
            best = candidate;
        }
    }
    return best;
}

}  // namespace rinceau
