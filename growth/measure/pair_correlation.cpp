// g_ab(r) = 1 / (2 pi r lambda_a lambda_b) * sum over i of kind a, j of kind b of k(r - |x_i - x_j|) / gamma(x_i - x_j),
// where gamma(v) is the area of the window that its copy moved by v covers.

#include "growth/measure/pair_correlation.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "geometry/kd_tree.h"

namespace rinceau {
namespace {

constexpr int radius_count = 40;
constexpr double kernel_half_width = 0.15;  ///< spacings
/// Steps at which less than this share of the window overlaps itself are left out: few pairs would count for many.
constexpr double least_overlap = 0.02;

/// The area of the window that its moved copy covers.
class WindowOverlap {
  public:
    WindowOverlap(const PointPattern& pattern, double longest)
        : tiled_(pattern.tile), whole_(area(pattern)), cell_(pattern.window.cell) {
        if (tiled_) return;
        const std::vector<double> values(pattern.window.inside.begin(), pattern.window.inside.end());
        const int steps = static_cast<int>(std::ceil(longest / cell_)) + 1;
        overlap_ = self_overlap(values, pattern.window.columns, pattern.window.rows, steps, steps, false);
    }
    /// 0 if it is too little to count with.
    double at(Point step) const {
        if (tiled_) return whole_;
        const double shared =
            cell_ * cell_ *
            overlap_.at(static_cast<int>(std::lround(step.x / cell_)), static_cast<int>(std::lround(step.y / cell_)));
        return shared < least_overlap * whole_ ? 0 : shared;
    }

  private:
    bool tiled_;
    double whole_, cell_;
    SelfOverlap overlap_;
};

/// The points, and of a tiled pattern copies of those within `margin` of the tile: which point each one is.
struct Surrounded {
    std::vector<Point> positions;
    std::vector<std::size_t> origins;
};

Surrounded surrounded(const PointPattern& pattern, double margin) {
    Surrounded all;
    const Box tile = pattern.tile.value_or(Box{});
    const int columns = pattern.tile ? static_cast<int>(std::ceil(margin / width(tile))) : 0;
    const int rows = pattern.tile ? static_cast<int>(std::ceil(margin / height(tile))) : 0;
    for (int row = -rows; row <= rows; ++row)
        for (int column = -columns; column <= columns; ++column)
            for (std::size_t i = 0; i < pattern.positions.size(); ++i) {
                const Point p = pattern.positions[i] + Point{column * width(tile), row * height(tile)};
                if (pattern.tile && !overlap(grown(tile, margin), including(Box{}, p))) continue;
                all.positions.push_back(p);
                all.origins.push_back(i);
            }
    return all;
}

/// Adds the pair's share to the sums at the radii (equally far from each other) that lie within the kernel.
void add_pair(std::vector<double>& sums, std::span<const double> radii, double bandwidth, double apart, double weight) {
    const double step = radii.size() > 1 ? radii[1] - radii[0] : 1;
    const double first = std::ceil((apart - bandwidth - radii[0]) / step);
    for (auto k = static_cast<std::size_t>(std::max(first, 0.0)); k < radii.size() && radii[k] < apart + bandwidth; ++k) {
        const double away = (radii[k] - apart) / bandwidth;
        sums[k] += weight * 0.75 / bandwidth * (1 - away * away);
    }
}

}  // namespace

PairCorrelation pair_correlation(const PointPattern& pattern, int symbols, std::span<const double> radii, double bandwidth) {
    const auto kinds = static_cast<std::size_t>(symbols);
    PairCorrelation result{{radii.begin(), radii.end()}, symbols, {}, std::vector<double>(kinds)};
    result.of_pair.assign(kinds * kinds, std::vector<double>(radii.size()));
    if (pattern.positions.empty() || radii.empty()) return result;
    const auto kind = [&pattern](std::size_t i) { return static_cast<std::size_t>(pattern.symbols[i]); };
    std::vector<double> counts(kinds);
    for (std::size_t i = 0; i < pattern.positions.size(); ++i) counts[kind(i)] += 1;
    for (std::size_t a = 0; a < kinds; ++a) result.shares[a] = counts[a] / static_cast<double>(pattern.positions.size());

    const double reach = radii.back() + bandwidth;
    const WindowOverlap window(pattern, reach);
    const Surrounded all = surrounded(pattern, reach);
    const KdTree tree(all.positions);
    for (std::size_t i = 0; i < pattern.positions.size(); ++i)
        for (const Neighbor& near : tree.within(pattern.positions[i], reach)) {
            const std::size_t j = all.origins[near.index];
            if (j == i) continue;
            const double shared = window.at(all.positions[near.index] - pattern.positions[i]);
            if (shared > 0) add_pair(result.of_pair[kind(i) * kinds + kind(j)], radii, bandwidth, near.distance, 1 / shared);
        }

    const double whole = area(pattern);
    for (std::size_t a = 0; a < kinds; ++a)
        for (std::size_t b = 0; b < kinds; ++b) {
            const double others = a == b ? counts[b] - 1 : counts[b];
            for (std::size_t k = 0; k < radii.size(); ++k) {
                const double expected = two_pi * radii[k] * counts[a] * others / (whole * whole);
                double& value = result.of_pair[a * kinds + b][k];
                value = expected > 0 ? value / expected : 0;
            }
        }
    return result;
}

double distance(const PairCorrelation& correlation, const PairCorrelation& reference) {
    const auto kinds = static_cast<std::size_t>(reference.symbols);
    double sum = 0, weights = 0;
    for (std::size_t k = 0; k < reference.radii.size(); ++k) {
        weights += reference.radii[k];
        for (std::size_t a = 0; a < kinds; ++a)
            for (std::size_t b = 0; b < kinds; ++b)
                sum += reference.radii[k] * reference.shares[a] * reference.shares[b] *
                       std::abs(correlation.of_pair[a * kinds + b][k] - reference.of_pair[a * kinds + b][k]);
    }
    return weights > 0 ? sum / weights : 0;
}

std::vector<double> correlation_radii(const PointPattern& reference, double spacing) {
    Box box;
    for (const Point p : reference.positions) box = including(box, p);
    if (reference.tile) box = *reference.tile;
    const double low = 0.25 * spacing, high = std::min(4 * spacing, 0.5 * std::min(width(box), height(box)));
    std::vector<double> radii;
    for (int k = 0; k < radius_count; ++k) radii.push_back(low + (std::max(high, 2 * low) - low) * k / (radius_count - 1));
    return radii;
}

double pair_distance(const PointPattern& pattern, const PointPattern& reference, int symbols, double spacing) {
    const std::vector<double> radii = correlation_radii(reference, spacing);
    const double bandwidth = kernel_half_width * spacing;
    return distance(pair_correlation(pattern, symbols, radii, bandwidth),
                    pair_correlation(reference, symbols, radii, bandwidth));
}

double pair_spread(const PointPattern& pattern, int symbols, double spacing) {
    const std::vector<double> radii = correlation_radii(pattern, spacing);
    const double bandwidth = kernel_half_width * spacing;
    double sum = 0;
    for (const int axis : {0, 1}) {
        const auto parts = halves(pattern, axis);
        sum += distance(pair_correlation(parts[0], symbols, radii, bandwidth),
                        pair_correlation(parts[1], symbols, radii, bandwidth));
    }
    return 0.5 * sum;
}

}  // namespace rinceau
