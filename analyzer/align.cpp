#include "analyzer/align.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"

namespace rinceau {

namespace {

using Harmonics = std::array<Complex, moment_orders>;

using Weights = std::array<std::array<double, moment_orders>, moment_powers>;

/// High orders are noisy: the weight of a moment is 0.35^(0.9 (k + 2q)).
constexpr Weights make_weights() {
    constexpr double ratio = 0.388747;  // 0.35^0.9
    Weights weights{};
    double of_power = 1;
    for (auto& row : weights) {
        double weight = of_power;
        for (double& w : row) {
            w = weight;
            weight *= ratio;
        }
        of_power *= ratio * ratio;
    }
    return weights;
}

constexpr Weights weights = make_weights();

/// C_k of the correlation S(t) = Re sum_k C_k exp(-ikt) of the two outlines' moments.
Harmonics correlation(const Moments& from, const Moments& to, bool mirrored) {
    Harmonics c{};
    for (std::size_t q = 0; q < moment_powers; ++q)
        for (std::size_t k = 1; k < moment_orders; ++k)
            c[k] += weights[q][k] * (conj(flipped_if(mirrored, from.value[q][k])) * to.value[q][k]);
    return c;
}

struct Slope {
    double value = 0, first = 0, second = 0;
};

Slope correlation_at(const Harmonics& c, double t) {
    const Complex step = polar(1, -t);
    Complex turn{1, 0};
    Slope s;
    for (std::size_t k = 1; k < moment_orders; ++k) {
        turn = turn * step;
        const Complex z = c[k] * turn;
        const double order = static_cast<double>(k);
        s.value += z.x;
        s.first += order * z.y;
        s.second -= order * order * z.x;
    }
    return s;
}

double newton_maximum(const Harmonics& c, double t) {
    constexpr int steps = 6;
    constexpr double longest_step = 0.3;  // radians: keeps a step in the basin of its start
    for (int i = 0; i < steps; ++i) {
        const Slope s = correlation_at(c, t);
        if (!(s.second < 0)) break;
        t -= std::clamp(s.first / s.second, -longest_step, longest_step);
    }
    return t;
}

/// The order whose peaks are the starts of the search: strong, and low because each order k has k peaks.
std::size_t leading_order(const Harmonics& c) {
    std::size_t best = 0;
    double best_strength = 0;
    for (std::size_t k = 1; k < moment_orders; ++k) {
        const double strength = abs(c[k]) / static_cast<double>(k);
        if (strength > 1.2 * best_strength) {
            best = k;
            best_strength = strength;
        }
    }
    return best;
}

}  // namespace

double alignment_residual(const Moments& from, const Moments& to, double angle, bool mirrored) {
    const Complex step = polar(1, angle);
    Complex turn{1, 0};
    double sum = 0;
    for (std::size_t k = 0; k < moment_orders; ++k) {
        for (std::size_t q = 0; q < moment_powers; ++q)
            sum += weights[q][k] * norm(to.value[q][k] - turn * flipped_if(mirrored, from.value[q][k]));
        turn = turn * step;
    }
    return std::sqrt(sum);
}

std::vector<Alignment> alignments(const Moments& from, const Moments& to, bool mirrored, double max_residual,
                                  std::size_t count) {
    const Harmonics c = correlation(from, to, mirrored);
    const std::size_t order = leading_order(c);
    std::vector<Alignment> found;
    const auto add = [&](double angle) {
        const Alignment a{wrap_angle(angle), mirrored, alignment_residual(from, to, angle, mirrored)};
        if (a.residual <= max_residual) found.push_back(a);
    };
    if (order == 0) add(0);  // nothing has a direction: any rotation is as good
    for (std::size_t j = 0; j < order; ++j)
        add(newton_maximum(c, (arg(c[order]) + two_pi * static_cast<double>(j)) / static_cast<double>(order)));
    std::ranges::stable_sort(found, {}, &Alignment::residual);
    if (found.size() > count) found.resize(count);
    return found;
}

}  // namespace rinceau
