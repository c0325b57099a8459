#include "analyzer/pose_grid.h"

#include <algorithm>
#include <cmath>

#include "geometry/box.h"

namespace rinceau {

int matching_gauge(const Part& part, const Similarity& pose, const Similarity& predicted, double turn) {
    // Only the linear parts: the part's symmetries fix its origin.
    const Complex inverse_linear = flipped_if(pose.mirrored, Complex{1, 0} / pose.linear);
    const Complex ratio = inverse_linear * flipped_if(pose.mirrored, predicted.linear);
    if (part.symmetry.continuous) return std::abs(abs(ratio) - 1) <= turn ? 0 : -1;
    const bool mirrored = pose.mirrored != predicted.mirrored;
    int best = -1;
    double best_error = turn * turn;
    for (std::size_t s = 0; s < part.symmetry.elements.size(); ++s) {
        const Similarity& element = part.symmetry.elements[s];
        if (element.mirrored != mirrored) continue;
        const double error = norm(element.linear - ratio);
        if (error <= best_error) {
            best_error = error;
            best = static_cast<int>(s);
        }
    }
    return best;
}

PoseGrid::PoseGrid(const RuleSet& rules, int part, std::span<const int> items) : rules_(&rules), part_(part) {
    Box box;
    for (const int i : items) box = including(box, rules.items[static_cast<std::size_t>(i)].pose.translation);
    const double count = std::max<double>(1, static_cast<double>(items.size()));
    // Half the mean spacing, whether the items fill the box or lie on a line.
    cell_ = 0.5 * std::max(std::sqrt(width(box) * height(box) / count), diagonal(box) / count);
    if (!(cell_ > 0)) cell_ = 1;

    std::vector<std::pair<std::int64_t, int>> keyed;
    keyed.reserve(items.size());
    for (const int i : items) {
        const Point p = rules.items[static_cast<std::size_t>(i)].pose.translation;
        keyed.emplace_back(key(std::llround(std::floor(p.x / cell_)), std::llround(std::floor(p.y / cell_))), i);
    }
    std::ranges::sort(keyed);
    items_.reserve(keyed.size());
    ranges_.reserve(keyed.size());
    for (const auto& [cell_key, item] : keyed) {
        const int at = static_cast<int>(items_.size());
        items_.push_back(item);
        auto [range, fresh] = ranges_.try_emplace(cell_key, Range{at, at});
        range->second.end = at + 1;
    }
}

void PoseGrid::consider(int item, const Similarity& predicted, double reach, double turn,
                        std::optional<PoseMatch>& best) const {
    const Item& candidate = rules_->items[static_cast<std::size_t>(item)];
    if (!candidate.alive) return;
    const double shift = abs(candidate.pose.translation - predicted.translation);
    if (shift > reach || (best && (shift > best->shift || (shift == best->shift && item >= best->item)))) return;
    const int gauge = matching_gauge(rules_->parts[static_cast<std::size_t>(part_)], candidate.pose, predicted, turn);
    if (gauge >= 0) best = PoseMatch{item, gauge, shift};
}

std::optional<PoseMatch> PoseGrid::find(const Similarity& predicted, double distance, const PoseTolerance& tolerance) const {
    const double reach = tolerance.shift(scale_of(predicted), distance);
    const double turn = tolerance.turn(rules_->parts[static_cast<std::size_t>(part_)].radius);
    const Point p = predicted.translation;
    std::optional<PoseMatch> best;
    if (!std::isfinite(reach) || !std::isfinite(p.x) || !std::isfinite(p.y)) return best;
    const auto cells = [&](double length) { return std::llround(std::floor(length / cell_)); };
    const auto x0 = cells(p.x - reach), x1 = cells(p.x + reach), y0 = cells(p.y - reach), y1 = cells(p.y + reach);
    if (static_cast<double>(x1 - x0 + 1) * static_cast<double>(y1 - y0 + 1) > static_cast<double>(items_.size())) {
        for (const int item : items_) consider(item, predicted, reach, turn, best);
        return best;
    }
    for (auto x = x0; x <= x1; ++x) {
        for (auto y = y0; y <= y1; ++y) {
            const auto range = ranges_.find(key(x, y));
            if (range == ranges_.end()) continue;
            for (int k = range->second.begin; k < range->second.end; ++k) {
                consider(items_[static_cast<std::size_t>(k)], predicted, reach, turn, best);
            }
        }
    }
    return best;
}

}  // namespace rinceau
