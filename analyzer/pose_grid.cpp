#include "analyzer/pose_grid.h"

#include <algorithm>
#include <cmath>

#include "geometry/box.h"
#include "geometry/index.h"

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

namespace {

/// The box that holds the items, but for a few far ones, which must not make the cells of all others large.
Box box_of_most(const RuleSet& rules, std::span<const int> items) {
    constexpr std::size_t most_samples = 500;
    constexpr double far_share = 0.02;  // of the items, on each side
    Box box;
    for (const int i : items) box = including(box, rules.items[static_cast<std::size_t>(i)].pose.translation);
    std::vector<double> xs, ys;
    for (std::size_t k = 0; k < items.size(); k += 1 + items.size() / most_samples) {
        const Point p = rules.items[static_cast<std::size_t>(items[k])].pose.translation;
        xs.push_back(p.x);
        ys.push_back(p.y);
    }
    const auto most_of = [](std::vector<double>& values, double& low, double& high) {
        std::ranges::sort(values);
        const auto left_out = static_cast<std::size_t>(far_share * static_cast<double>(values.size()));
        const double first = values[left_out], last = values[values.size() - 1 - left_out];
        low = std::max(low, first - 0.5 * (last - first));
        high = std::min(high, last + 0.5 * (last - first));
    };
    if (xs.empty()) return box;
    most_of(xs, box.low.x, box.high.x);
    most_of(ys, box.low.y, box.high.y);
    return box;
}

}  // namespace

int PoseGrid::cell_index(double offset, double per_cell, int count) {
    return static_cast<int>(std::clamp(offset * per_cell, 0.0, static_cast<double>(count - 1)));
}

PoseGrid::PoseGrid(const RuleSet& rules, int part, std::span<const int> items) : rules_(&rules), part_(part) {
    const Box box = box_of_most(rules, items);
    const double count = std::max<double>(1, static_cast<double>(items.size()));
    // Half the mean spacing, whether the items fill the box or lie on a line: at most 9 cells for each item.
    const double cell = 0.5 * std::max(std::sqrt(width(box) * height(box) / count), diagonal(box) / count);
    if (cell > 0) {
        low_ = box.low;
        per_cell_ = 1 / cell;
        columns_ = 1 + static_cast<int>(width(box) * per_cell_);
        rows_ = 1 + static_cast<int>(height(box) * per_cell_);
    }
    // Sorted by cell: count, sum up, fill.
    begin_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
    std::vector<int> cells;
    cells.reserve(items.size());
    for (const int i : items) {
        const Point p = rules.items[static_cast<std::size_t>(i)].pose.translation;
        cells.push_back(row(p.y) * columns_ + column(p.x));
        ++begin_[static_cast<std::size_t>(cells.back()) + 1];
    }
    for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
    std::vector<int> next(begin_.begin(), begin_.end() - 1);
    places_.resize(items.size());
    for (std::size_t k = 0; k < items.size(); ++k) {
        const int at = next[static_cast<std::size_t>(cells[k])]++;
        places_[static_cast<std::size_t>(at)] = {rules.items[static_cast<std::size_t>(items[k])].pose.translation, items[k]};
    }
}

void PoseGrid::consider(const Place& place, const Similarity& predicted, double reach, double turn,
                        std::optional<PoseMatch>& best) const {
    const double shift = abs(place.origin - predicted.translation);
    if (shift > reach || (best && (shift > best->shift || (shift == best->shift && place.item >= best->item)))) return;
    const Item& candidate = rules_->items[static_cast<std::size_t>(place.item)];
    if (!candidate.alive) return;
    const int gauge = matching_gauge(rules_->parts[static_cast<std::size_t>(part_)], candidate.pose, predicted, turn);
    if (gauge >= 0) best = PoseMatch{place.item, gauge, shift};
}

std::optional<PoseMatch> PoseGrid::find(const Similarity& predicted, double distance, const PoseTolerance& tolerance) const {
    const double reach = tolerance.shift(scale_of(predicted), distance);
    const double turn = tolerance.turn(rules_->parts[static_cast<std::size_t>(part_)].radius);
    const Point p = predicted.translation;
    std::optional<PoseMatch> best;
    if (!std::isfinite(reach) || !std::isfinite(p.x) || !std::isfinite(p.y)) return best;
    const int x0 = column(p.x - reach), x1 = column(p.x + reach), y1 = row(p.y + reach);
    for (int y = row(p.y - reach); y <= y1; ++y) {
        const std::size_t first = table_index(y, x0, columns_), last = table_index(y, x1, columns_);
        for (int k = begin_[first]; k < begin_[last + 1]; ++k) {
            consider(places_[static_cast<std::size_t>(k)], predicted, reach, turn, best);
        }
    }
    return best;
}

}  // namespace rinceau
