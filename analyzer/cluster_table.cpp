#include "analyzer/cluster_table.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <utility>

#include "analyzer/pose_tolerance.h"

namespace rinceau {

namespace {

constexpr const char* stage = "clusters";

/// A pair of a cluster that goes on in a sequence.
struct Follower {
    int element = -1;
    double miss = 0;  ///< from the cluster's step, in sizes of `element`
};

/// The advance of a point as a vector in the frame of its `from` element.
Complex advance(double alpha, double d) { return polar(d, alpha); }

double miss_of(const TransformationPoint& point, const TransformationCluster& step) {
    return abs(advance(point.alpha, point.d) - advance(step.alpha, step.d)) / point.s;
}

/// Half the way across each look in its unit frame.
std::vector<double> reaches(const Instancing& instancing) {
    std::vector<double> reach;
    for (const Look& look : instancing.looks) {
        const Box box = bounds(look.paths);
        reach.push_back(is_empty(box) ? 0 : std::max({std::abs(box.low.x), std::abs(box.low.y), box.high.x, box.high.y}));
    }
    return reach;
}

/// Sequences of a cluster: chains from pair to pair, each element in one.
struct ChainCount {
    double elements = 0;
    double chains = 0;
};

ChainCount chains_of(const std::map<int, Follower>& next) {
    std::map<int, int> previous;
    for (const auto& [from, follower] : next) previous.try_emplace(follower.element, from);
    ChainCount count;
    std::map<int, bool> seen;
    const auto walk = [&](int from) {
        double length = 0;
        for (int at = from; !std::exchange(seen[at], true);) {
            ++length;
            const auto on = next.find(at);
            if (on == next.end() || previous.at(on->second.element) != at) break;
            at = on->second.element;
        }
        if (length < 2) return;
        count.elements += length;
        ++count.chains;
    };
    for (const auto& [from, follower] : next)
        if (!previous.contains(from)) walk(from);
    for (const auto& [from, follower] : next)  // the closed ones
        if (!seen[from]) walk(from);
    return count;
}

class Tabulator {
  public:
    Tabulator(const Instancing& instancing, double diagonal)
        : instancing_(instancing), diagonal_(diagonal > 0 ? diagonal : 1), reach_(reaches(instancing)) {}

    ClusterRow row(const ClusteredSpace& clustered, int space, int cluster, const std::vector<std::size_t>& points) const {
        const TransformationCluster& step = clustered.clusters.clusters[static_cast<std::size_t>(cluster)];
        const bool one_look = clustered.space.from == clustered.space.to;
        ClusterRow row{space, cluster, {}, {}};
        std::map<int, Follower> next;
        for (const std::size_t p : points) {
            const TransformationPoint& point = clustered.space.points[p];
            const double miss = miss_of(point, step);
            row.terms.nearness += 1 - gap(point) / diagonal_;
            if (one_look) row.terms.similarity += 1 / (1 + miss / PoseTolerance{}.size);
            Follower& follower = next.try_emplace(point.from, Follower{point.to, miss}).first->second;
            if (miss < follower.miss) follower = {point.to, miss};
            row.elements.push_back(point.from);
            row.elements.push_back(point.to);
        }
        std::ranges::sort(row.elements);
        row.elements.erase(std::unique(row.elements.begin(), row.elements.end()), row.elements.end());
        row.terms.nearness /= static_cast<double>(points.size());
        row.terms.similarity /= static_cast<double>(points.size());
        count_elements(row, one_look, next);
        return row;
    }

  private:
    static void count_elements(ClusterRow& row, bool one_look, const std::map<int, Follower>& next) {
        constexpr double in_a_pair = 2;
        const ChainCount chains = one_look ? chains_of(next) : ChainCount{};
        row.terms.elements = one_look ? chains.elements : static_cast<double>(row.elements.size());
        row.terms.length = one_look && chains.chains > 0 ? chains.elements / chains.chains : in_a_pair;
    }

    /// Between the two elements, as circles; scene length.
    double gap(const TransformationPoint& point) const {
        const auto circle = [&](int element) {
            const Instance& instance = instancing_.instances[static_cast<std::size_t>(element)];
            return std::pair{instance.pose.translation,
                             scale_of(instance.pose) * reach_[static_cast<std::size_t>(instance.look)]};
        };
        const auto [a, reach_a] = circle(point.from);
        const auto [b, reach_b] = circle(point.to);
        return std::clamp(abs(a - b) - reach_a - reach_b, 0.0, diagonal_);
    }

    const Instancing& instancing_;
    double diagonal_;
    std::vector<double> reach_;
};

std::size_t possible_spaces(const Instancing& instancing) {
    std::vector<std::size_t> times(instancing.looks.size(), 0);
    for (const Instance& instance : instancing.instances) {
        const auto look = static_cast<std::size_t>(instance.look);
        if (instancing.looks[look].verbatim.empty()) ++times[look];
    }
    const auto used = static_cast<std::size_t>(std::ranges::count_if(times, [](std::size_t n) { return n > 0; }));
    const auto single = static_cast<std::size_t>(std::ranges::count(times, 1U));
    return used * used - single;
}

std::vector<std::vector<std::size_t>> points_by_cluster(const TransformationClusters& clusters) {
    std::vector<std::vector<std::size_t>> points(clusters.clusters.size());
    for (std::size_t p = 0; p < clusters.cluster_of.size(); ++p)
        points[static_cast<std::size_t>(clusters.cluster_of[p])].push_back(p);
    return points;
}

void keep_largest_rows(ClusterTable& table, std::size_t most) {
    std::ranges::stable_sort(table.rows, std::greater{}, [](const ClusterRow& row) { return row.elements.size(); });
    if (table.rows.size() <= most) return;
    table.rows.resize(most);
    table.complete = false;
}

}  // namespace

ClusterTable cluster_table(const Instancing& instancing, const std::vector<std::string>& names, double diagonal,
                           const ClusterTableOptions& options, const Progress& progress) {
    ClusterTable table;
    table.names = names;
    report(progress, stage, 0);
    std::vector<TransformationSpace> spaces = fill_transformation_spaces(instancing, {.most_points = options.most_points});
    table.complete = spaces.size() == possible_spaces(instancing);
    const Tabulator tabulator(instancing, diagonal);
    const double count = static_cast<double>(spaces.size());
    for (TransformationSpace& space : spaces) {
        const int index = static_cast<int>(table.spaces.size());
        report(progress, stage, index / count);
        TransformationClusters clusters = mean_shift(space.points);
        table.spaces.push_back({std::move(space), std::move(clusters)});
        const ClusteredSpace& clustered = table.spaces.back();
        const std::vector<std::vector<std::size_t>> points = points_by_cluster(clustered.clusters);
        for (std::size_t c = 0; c < points.size(); ++c)
            if (points[c].size() >= 2) table.rows.push_back(tabulator.row(clustered, index, static_cast<int>(c), points[c]));
    }
    keep_largest_rows(table, options.most_rows);
    for (const ClusterRow& row : table.rows) {
        table.largest.elements = std::max(table.largest.elements, row.terms.elements);
        table.largest.length = std::max(table.largest.length, row.terms.length);
    }
    return table;
}

RankedClusters ranked_clusters(const ClusterTable& table, const ImportanceWeights& weights) {
    RankedClusters ranked;
    ranked.order.resize(table.rows.size());
    std::iota(ranked.order.begin(), ranked.order.end(), std::size_t{0});
    for (const ClusterRow& row : table.rows) ranked.importance.push_back(importance(row.terms, table.largest, weights));
    std::ranges::stable_sort(ranked.order, std::greater{}, [&](std::size_t row) { return ranked.importance[row]; });
    return ranked;
}

}  // namespace rinceau
