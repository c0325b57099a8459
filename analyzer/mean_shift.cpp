#include "analyzer/mean_shift.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "geometry/angle.h"

namespace rinceau {

namespace {

/// A point in units of the bandwidths; angles kept in one turn.
using Place = std::array<double, 4>;  // alpha, d, log s, beta
constexpr std::size_t alpha_axis = 0;
constexpr std::size_t beta_axis = 3;

class Metric {
  public:
    explicit Metric(const MeanShiftBandwidths& b) : widths_{b.alpha, b.d, b.log_scale, b.beta} {}

    Place place(const TransformationPoint& p) const {
        return {p.alpha / widths_[0], p.d / widths_[1], std::log(p.s) / widths_[2], p.beta / widths_[3]};
    }
    /// b - a, angles the short way round.
    Place difference(const Place& a, const Place& b) const {
        Place result;
        for (std::size_t i = 0; i < result.size(); ++i) result[i] = is_angle(i) ? wrapped(b[i] - a[i], i) : b[i] - a[i];
        return result;
    }
    Place wrapped(Place p) const {
        for (const std::size_t i : {alpha_axis, beta_axis}) p[i] = wrapped(p[i], i);
        return p;
    }
    double turn(std::size_t axis) const { return two_pi / widths_[axis]; }
    double width(std::size_t axis) const { return widths_[axis]; }
    static bool is_angle(std::size_t axis) { return axis == alpha_axis || axis == beta_axis; }

  private:
    double wrapped(double value, std::size_t axis) const { return wrap_angle(value * widths_[axis]) / widths_[axis]; }
    std::array<double, 4> widths_;
};

double squared_length(const Place& p) { return std::inner_product(p.begin(), p.end(), p.begin(), 0.0); }

/// Places in bins of a sixteenth of a bandwidth, one standing for all in it: periodic drawings have thousands in one place.
struct Bins {
    std::vector<Place> places;  ///< means
    std::vector<double> weights;
    std::vector<std::size_t> bin_of;  ///< of each place that was binned
};

Bins binned(const std::vector<Place>& places) {
    constexpr double per_bandwidth = 16;
    std::map<std::array<std::int64_t, 4>, std::size_t> number;  // ordered: the bins do not depend on the order of points
    std::vector<std::array<std::int64_t, 4>> cells;
    for (const Place& place : places) {
        std::array<std::int64_t, 4> cell;
        for (std::size_t k = 0; k < cell.size(); ++k)
            cell[k] = static_cast<std::int64_t>(std::floor(per_bandwidth * place[k]));
        cells.push_back(cell);
        number.emplace(cell, 0);
    }
    Bins bins;
    for (auto& [cell, n] : number) n = bins.places.size(), bins.places.push_back({}), bins.weights.push_back(0);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::size_t bin = number.at(cells[i]);
        bins.bin_of.push_back(bin);
        for (std::size_t k = 0; k < places[i].size(); ++k) bins.places[bin][k] += places[i][k];
        ++bins.weights[bin];
    }
    for (std::size_t bin = 0; bin < bins.places.size(); ++bin)
        for (double& part : bins.places[bin]) part /= bins.weights[bin];
    return bins;
}

/// Points by cells of one bandwidth; circular axes have a whole number of cells, none narrower than that.
class PlaceGrid {
  public:
    PlaceGrid(const std::vector<Place>& places, const Metric& metric) : places_(places), metric_(metric) {
        for (const std::size_t axis : {alpha_axis, beta_axis})
            cells_of_turn_[axis] = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::floor(metric.turn(axis))));
        for (std::size_t i = 0; i < places.size(); ++i) cells_[code(cell_of(places[i]))].push_back(static_cast<int>(i));
    }

    /// Calls visit(index, difference) for all points within one bandwidth.
    template <class Visit>
    void for_near(const Place& center, Visit visit) const {
        const Cell middle = cell_of(center);
        std::array<std::uint64_t, 81> codes;  // cells of 3^4; few cells to the turn make some of them equal
        std::size_t count = 0;
        for (int a = -1; a <= 1; ++a)
            for (int b = -1; b <= 1; ++b)
                for (int c = -1; c <= 1; ++c)
                    for (int e = -1; e <= 1; ++e)
                        codes[count++] =
                            code({around(middle[0] + a, 0), middle[1] + b, middle[2] + c, around(middle[3] + e, 3)});
        std::sort(codes.begin(), codes.end());
        const auto last = std::unique(codes.begin(), codes.end());
        for (auto cell = codes.begin(); cell != last; ++cell) {
            const auto found = cells_.find(*cell);
            if (found == cells_.end()) continue;
            for (const int i : found->second) {
                const Place difference = metric_.difference(center, places_[static_cast<std::size_t>(i)]);
                if (squared_length(difference) <= 1) visit(i, difference);
            }
        }
    }

  private:
    using Cell = std::array<std::int64_t, 4>;

    std::int64_t around(std::int64_t cell, std::size_t axis) const {
        const std::int64_t n = cells_of_turn_[axis];
        return ((cell % n) + n) % n;
    }
    Cell cell_of(const Place& p) const {
        Cell cell;
        for (std::size_t i = 0; i < cell.size(); ++i) {
            if (Metric::is_angle(i)) {
                const double share = p[i] / metric_.turn(i) + 0.5;
                cell[i] = around(static_cast<std::int64_t>(std::floor(share * static_cast<double>(cells_of_turn_[i]))), i);
            } else {
                cell[i] = static_cast<std::int64_t>(std::floor(p[i]));
            }
        }
        return cell;
    }
    /// Different cells of one code only cost a comparison.
    static std::uint64_t code(const Cell& cell) {
        std::uint64_t sum = 0;
        for (const std::int64_t part : cell) {
            sum = (sum ^ static_cast<std::uint64_t>(part)) * 0x9E3779B97F4A7C15u;
            sum ^= sum >> 29;
        }
        return sum;
    }

    const std::vector<Place>& places_;
    const Metric& metric_;
    std::array<std::int64_t, 4> cells_of_turn_{1, 1, 1, 1};
    std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

/// Where the point ends when it moves to the mean of its neighbours again and again.
Place climb(Place place, const PlaceGrid& grid, const std::vector<double>& weights, const Metric& metric) {
    constexpr int most_steps = 200;
    constexpr double arrived = 1e-9;  // squared, in bandwidths
    for (int step = 0; step < most_steps; ++step) {
        Place sum{};
        double count = 0;  // of points
        grid.for_near(place, [&](int neighbor, const Place& difference) {
            const double weight = weights[static_cast<std::size_t>(neighbor)];
            for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * difference[i];
            count += weight;
        });
        if (count == 0) break;
        for (double& part : sum) part /= count;
        for (std::size_t i = 0; i < place.size(); ++i) place[i] += sum[i];
        place = metric.wrapped(place);
        if (squared_length(sum) < arrived) break;
    }
    return place;
}

/// Modes nearer than half a bandwidth, directly or through others, are one. Labels by first point.
std::vector<int> join_modes(const std::vector<Place>& modes, const Metric& metric) {
    constexpr double same_mode = 0.5;
    const PlaceGrid grid(modes, metric);
    std::vector<int> label(modes.size(), -1);
    int labels = 0;
    for (std::size_t seed = 0; seed < modes.size(); ++seed) {
        if (label[seed] >= 0) continue;
        std::vector<std::size_t> open{seed};
        label[seed] = labels;
        while (!open.empty()) {
            const std::size_t at = open.back();
            open.pop_back();
            grid.for_near(modes[at], [&](int i, const Place& difference) {
                int& other = label[static_cast<std::size_t>(i)];
                if (other >= 0 || squared_length(difference) > same_mode * same_mode) return;
                other = labels;
                open.push_back(static_cast<std::size_t>(i));
            });
        }
        ++labels;
    }
    return label;
}

/// The mean mode of each label's points.
std::vector<TransformationCluster> clusters_of(const std::vector<Place>& modes, const std::vector<int>& label,
                                               const std::vector<double>& weights, const Metric& metric) {
    struct Sum {
        Place first{}, offset{};
        double weight = 0;
    };
    std::vector<Sum> sums;
    for (std::size_t i = 0; i < modes.size(); ++i) {
        const std::size_t cluster = static_cast<std::size_t>(label[i]);
        if (cluster == sums.size()) sums.push_back({modes[i], {}, 0});
        Sum& sum = sums[cluster];
        const Place difference = metric.difference(sum.first, modes[i]);
        for (std::size_t k = 0; k < difference.size(); ++k) sum.offset[k] += weights[i] * difference[k];
        sum.weight += weights[i];
    }
    std::vector<TransformationCluster> clusters;
    for (const Sum& sum : sums) {
        Place mode = sum.first;
        for (std::size_t k = 0; k < mode.size(); ++k) mode[k] += sum.offset[k] / sum.weight;
        mode = metric.wrapped(mode);
        clusters.push_back({mode[0] * metric.width(0), mode[1] * metric.width(1), std::exp(mode[2] * metric.width(2)),
                            mode[3] * metric.width(3), false, static_cast<int>(std::lround(sum.weight))});
    }
    return clusters;
}

/// One sheet of the space, mirrored or not: appends its clusters.
void cluster_sheet(const std::vector<TransformationPoint>& points, bool mirrored, const Metric& metric,
                   TransformationClusters& result) {
    std::vector<std::size_t> members;
    std::vector<Place> places;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i].mirrored == mirrored) {
            members.push_back(i);
            places.push_back(metric.place(points[i]));
        }
    const Bins bins = binned(places);
    const PlaceGrid grid(bins.places, metric);
    std::vector<Place> modes;
    for (const Place& place : bins.places) modes.push_back(climb(place, grid, bins.weights, metric));
    const std::vector<int> label = join_modes(modes, metric);
    const int base = static_cast<int>(result.clusters.size());
    for (TransformationCluster cluster : clusters_of(modes, label, bins.weights, metric)) {
        cluster.mirrored = mirrored;
        result.clusters.push_back(cluster);
    }
    for (std::size_t i = 0; i < members.size(); ++i) result.cluster_of[members[i]] = base + label[bins.bin_of[i]];
}

TransformationClusters by_falling_count(TransformationClusters clusters) {
    std::vector<int> order(clusters.clusters.size());
    std::iota(order.begin(), order.end(), 0);
    std::vector<std::size_t> first(order.size(), clusters.cluster_of.size());
    for (std::size_t i = clusters.cluster_of.size(); i-- > 0;) first[static_cast<std::size_t>(clusters.cluster_of[i])] = i;
    std::ranges::sort(order, {}, [&](int c) {
        return std::pair{-clusters.clusters[static_cast<std::size_t>(c)].count, first[static_cast<std::size_t>(c)]};
    });
    TransformationClusters sorted;
    std::vector<int> rank(order.size());
    for (const int c : order) {
        rank[static_cast<std::size_t>(c)] = static_cast<int>(sorted.clusters.size());
        sorted.clusters.push_back(clusters.clusters[static_cast<std::size_t>(c)]);
    }
    for (const int c : clusters.cluster_of) sorted.cluster_of.push_back(rank[static_cast<std::size_t>(c)]);
    return sorted;
}

}  // namespace

TransformationClusters mean_shift(const std::vector<TransformationPoint>& points, const MeanShiftBandwidths& bandwidths) {
    const Metric metric(bandwidths);
    TransformationClusters result;
    result.cluster_of.resize(points.size());
    for (const bool mirrored : {false, true}) cluster_sheet(points, mirrored, metric, result);
    return by_falling_count(std::move(result));
}

}  // namespace rinceau
