#include "analyzer/even_places.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "analyzer/arrangement.h"

namespace rinceau {

namespace {

constexpr double gap_bits = 14;      // one distance, written out
constexpr double change_bits = 4;    // where one distance gives way to another
constexpr std::size_t most_places = 400;

struct Crowds {
    std::vector<int> crowd_of;
    std::vector<double> means, counts;
    double spread = 0;
};

Crowds crowds_of(std::span<const double> values, double split) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[i]; });
    Crowds crowds;
    crowds.crowd_of.resize(values.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        if (k == 0 || values[order[k]] - values[order[k - 1]] > split) {
            crowds.means.push_back(0);
            crowds.counts.push_back(0);
        }
        crowds.crowd_of[order[k]] = static_cast<int>(crowds.means.size()) - 1;
        crowds.means.back() += values[order[k]];
        ++crowds.counts.back();
    }
    for (std::size_t c = 0; c < crowds.means.size(); ++c) crowds.means[c] /= crowds.counts[c];
    double squares = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double off = values[i] - crowds.means[static_cast<std::size_t>(crowds.crowd_of[i])];
        squares += off * off;
    }
    const double freedom = static_cast<double>(values.size() - std::min(values.size() - 1, crowds.means.size()));
    crowds.spread = std::sqrt(squares / freedom);
    return crowds;
}

/// Gaps that differ by at most `width` are one class; classes are numbered in order of appearance.
std::vector<int> gap_classes(const std::vector<double>& means, double width) {
    std::vector<double> gaps;
    for (std::size_t j = 1; j < means.size(); ++j) gaps.push_back(means[j] - means[j - 1]);
    std::vector<double> sorted = gaps, starts;
    std::ranges::sort(sorted);
    for (const double gap : sorted) {
        if (starts.empty() || gap > starts.back() + width) starts.push_back(gap);
    }
    std::vector<int> name(starts.size(), -1), classes;
    int named = 0;
    for (const double gap : gaps) {
        const auto at = static_cast<std::size_t>(std::ranges::upper_bound(starts, gap) - starts.begin() - 1);
        if (name[at] < 0) name[at] = named++;
        classes.push_back(name[at]);
    }
    return classes;
}

/// Least squares of the crowds' means by a first place and one gap for each class.
std::vector<double> fitted_places(const Crowds& crowds, const std::vector<int>& classes, int count) {
    const auto rows = static_cast<Eigen::Index>(crowds.means.size());
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(rows, count + 1);
    Eigen::VectorXd wanted(rows);
    Eigen::VectorXd steps = Eigen::VectorXd::Zero(count + 1);
    steps(0) = 1;
    Eigen::MatrixXd plain(rows, count + 1);
    for (Eigen::Index j = 0; j < rows; ++j) {
        if (j > 0) steps(classes[static_cast<std::size_t>(j - 1)] + 1) += 1;
        const double weight = std::sqrt(crowds.counts[static_cast<std::size_t>(j)]);
        plain.row(j) = steps.transpose();
        system.row(j) = weight * steps.transpose();
        wanted(j) = weight * crowds.means[static_cast<std::size_t>(j)];
    }
    const Eigen::VectorXd places = plain * system.colPivHouseholderQr().solve(wanted);
    return {places.data(), places.data() + places.size()};
}

EvenPlaces measured(std::span<const double> values, const Crowds& crowds, std::vector<int> classes, double precision) {
    EvenPlaces even;
    even.place_of = crowds.crowd_of;
    even.gap_classes = std::move(classes);
    for (const int c : even.gap_classes) even.classes = std::max(even.classes, c + 1);
    even.places = fitted_places(crowds, even.gap_classes, even.classes);
    double squares = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double off = values[i] - even.places[static_cast<std::size_t>(even.place_of[i])];
        squares += off * off;
    }
    const auto n = static_cast<double>(values.size());
    even.spread = std::sqrt(squares / n);
    double mean_gap = 0;
    for (std::size_t j = 1; j < even.places.size(); ++j) {
        const double gap = even.places[j] - even.places[j - 1];
        even.least_gap = j == 1 ? gap : std::min(even.least_gap, gap);
        mean_gap += gap / static_cast<double>(even.places.size() - 1);
    }
    int changes = 0;
    for (std::size_t j = 1; j < even.gap_classes.size(); ++j) changes += even.gap_classes[j] != even.gap_classes[j - 1];
    even.bits = n * std::log2(1 + even.spread / precision) + gap_bits * (1 + even.classes) + change_bits * changes;
    if (even.places.size() > 1) {
        // In a crowd by chance: all but one of each; an even gap by chance: all but one of each class.
        const double crowded = n - static_cast<double>(even.places.size());
        const double evened = static_cast<double>(even.gap_classes.size()) - even.classes;
        even.chance_bits = (crowded + evened) * log2_hit(even.spread, mean_gap);
    }
    return even;
}

}  // namespace

EvenPlaces even_places(std::span<const double> values, double split, double precision) {
    const Crowds crowds = crowds_of(values, split);
    if (crowds.means.size() > most_places) {
        EvenPlaces none;
        none.bits = HUGE_VAL;
        return none;
    }
    const auto places = static_cast<double>(crowds.means.size());
    const double error = crowds.spread * std::sqrt(2 * places / static_cast<double>(values.size()));
    const double mean_gap = places > 1 ? (crowds.means.back() - crowds.means.front()) / (places - 1) : 0;
    // How different equal gaps may look: by the error of the means, or, where these say nothing, by shares of the gap.
    EvenPlaces best;
    best.bits = HUGE_VAL;
    for (const double width : {1e-6 * mean_gap, 2.5 * error, 5 * error, 8 * error, 0.05 * mean_gap, 0.25 * mean_gap, 0.6 * mean_gap}) {
        EvenPlaces even = measured(values, crowds, gap_classes(crowds.means, width), precision);
        if (even.bits < best.bits) best = std::move(even);
    }
    return best;
}

}  // namespace rinceau
